#pragma once
/// Construction plans of general scenes: points, lines and planes are placed one by one, by what is stated between them
/// and elements placed before. [H] §5 and [I] with planes and lines beside points.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solvers/construction/closed_forms.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

/// The coordinates of an element without a frame. In the plane a point's third is one that the frame makes 0.
int coordinates_of(const ProblemStatement& problem, int element);

struct ElementStep {
  int place = -1;
  bool is_origin = false;
  std::vector<int> zeros;        ///< axes along which the frame says 0
  int positive = -1;             ///< the axis along which the frame says > 0; −1: none
  std::vector<GivenFrom> given;  ///< from points first, then from planes, then from lines
  int first_angle = 0;
  int angles = 0;  ///< the coordinates that nothing given takes: driving parameters
};

struct ElementPlan {
  std::vector<ElementStep> steps;
  std::vector<std::array<double, 2>> ranges;  ///< of each angle, in radians

  /// The frame in which the plan builds: its first points as origin, axis and, in space, plane. Precondition: it begins
  /// with a point as the origin.
  Reference frame() const;
};

/// What an instruction is to do: find all places of its element at given angles, in closed form; or follow one place as
/// the elements before move, for which anything given will do.
enum class Instructions { all_places, one_place };

/// Why a general scene has no such plan: which element no instruction places, and what it is met by. Nothing where there
/// is a plan.
std::optional<std::string> why_no_element_plan(const Scene& scene, Instructions instructions);

/// The plan with the fewest angles among those that begin at an edge, or at what is fixed or rests in the frame, and go on
/// with the element that needs the fewest. What it does not use is left to close it. Precondition: nothing from
/// why_no_element_plan.
ElementPlan derive_element_plan(const Scene& scene, Instructions instructions);

/// The plan in words, a text for each instruction: "L from p1 (a13), p2 (a14); 2 driving parameters", of an element that
/// these and the frame place with what constraints say.
std::vector<std::string> describe_plan(const ProblemStatement& problem, const ElementPlan& plan);

}  // namespace gcs
