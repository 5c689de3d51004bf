#pragma once
/// Which elements and bodies of a scene can be placed one after another, in its frame, whatever their kinds are.

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/structure/sub_problem.hpp"

namespace gcs {

/// What is placed when the steps before it are: as many equations as unknowns are left then.
struct PlacingStep {
  /// The element, or those that a body or several ones place; none: a core, which is solved first.
  std::vector<int> entities{};
  int bodies = 0;
  std::string name{};            ///< of the element or the bodies
  std::vector<int> unknowns{};   ///< of these, and those that their constraints bring along
  std::vector<int> equations{};  ///< as many
  int quadratic = 0;             ///< how many of them are, in the step's unknowns
  std::vector<int> after{};      ///< the steps on whose choice these depend, ascending
  /// Of the unknowns, the changes of signs that leave all that was placed before.
  SignMasks signs{};
  /// The scene of its own that a core is, or an element that hangs on nothing but given positions.
  std::optional<SubProblem> alone{};
  /// The mirror image in the frame of each of its solutions is another one: that class of its own is two here.
  bool has_two_sides = false;

  bool is_core() const { return entities.empty(); }
};

/// What may be taken away from a scene: free elements alone, or bodies too.
enum class Taken { elements, bodies_too };

/// In the order in which they are placed: taken away, last ones first, while one hangs on what is left, or two
/// bodies that hold each other do. What makes the
/// frame is not taken, nor what may have more than 2^12 solutions.
std::vector<PlacingStep> placing_steps(const SceneSystem& system, Taken taken);

/// The unknowns that say where an entity is.
std::set<int> unknowns_of(const SystemBuilder& elements, int entity);
/// Those of an equation.
std::set<int> unknowns_of(const QuadraticEquation& equation);
/// The number of independent changes of signs that turn elements over, and leave the frame.
int turnings(const SignMasks& masks);
bool meets(const std::set<int>& a, const std::set<int>& b);
/// The points that make the frame; none where a body or given positions do.
std::set<int> framing_points(const Scene& scene);

}  // namespace gcs
