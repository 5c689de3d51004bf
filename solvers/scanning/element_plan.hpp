#pragma once
/// Construction plans of general scenes: points and planes are placed one by one, by distances from points and planes
/// placed before and, planes, by angles with planes. [H] §5 with planes beside the points of [I].
///
/// Each step is a sphere that planes cut. Of a point the sphere is around another point; what a further sphere has in
/// common with it lies in a plane, and a plane at a distance is one. Of a plane n·x = h the normal lies on the unit
/// sphere, h follows from one point's distance, and every further distance or angle is linear in n. What is missing of
/// two cutting planes are angles.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solvers/model/scene.hpp"

namespace gcs {

/// What a plan can build on: the distance of two points or of a point and a plane, as seen from its side, or the cosine
/// of two planes, in the scene's unit.
struct ElementPair {
  std::array<int, 2> of{};
  double value = 0;
};

/// One end of a pair as seen from the other.
struct GivenFrom {
  int other = -1;
  double value = 0;
};

struct ElementStep {
  int place = -1;
  bool is_origin = false;
  std::vector<int> zeros;  ///< axes along which the frame says 0
  int positive = -1;       ///< the axis along which the frame says > 0; −1: none
  std::vector<GivenFrom> points;
  std::vector<GivenFrom> planes;
  int first_angle = 0;
  int angles = 0;
};

struct ElementPlan {
  std::vector<ElementStep> steps;
  std::vector<std::array<double, 2>> ranges;  ///< of each angle, in radians
};

/// Why a general scene has no such plan: which element no instruction places. Nothing where there is a plan.
std::optional<std::string> why_no_element_plan(const Scene& scene);

/// The plan with the fewest angles among those that begin at an edge, or at the points that are fixed, and go on with the
/// element that needs the fewest. What it does not use is left for the scan to close. Precondition: nothing from
/// why_no_element_plan.
ElementPlan derive_element_plan(const Scene& scene);

}  // namespace gcs
