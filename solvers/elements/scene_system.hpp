#pragma once
/// The equations of a general scene: points, lines, planes and bodies with everything that the file states between them,
/// as one sparse system of degree two with the exact numbers of the file, in the scene's unit and frame.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "solvers/elements/system_builder.hpp"

namespace gcs {

/// Why there is no system for the scene, in a sentence; nothing where there is one.
std::optional<std::string> why_no_system(const Scene& scene);

class SceneSystem {
 public:
  /// Precondition: !why_no_system(scene). The scene outlives this.
  explicit SceneSystem(const Scene& scene);

  const QuadraticSystem& equations() const { return builder_.system(); }
  /// Of each equation the value that it gives, or no_value, or gap_value.
  const std::vector<int>& value_of() const { return builder_.value_of(); }
  /// The equations that give no value.
  std::vector<int> without_value() const;
  /// Those of them that close no loop of joints: each is met whatever the values and gaps.
  std::vector<int> of_parts() const;
  /// Of each equation the constraint that it belongs to, numbered as values are, no_value where it is an
  /// element's, or owner_of_joints.
  const std::vector<int>& owner_of() const { return builder_.owner_of(); }
  /// Whether the entity's coordinates change with one of these changes of the unknowns, columns of length 1.
  bool moves(int entity, const Eigen::MatrixXcd& changes) const;
  /// Where the points, lines and planes of the scene are, as forms in the unknowns.
  const SystemBuilder& elements() const { return builder_; }
  /// The unknowns at a solution, or near one, in the scene's frame: lengths of segments have the signs with which the
  /// equations of angles hold.
  ComplexValues coordinates(const Figure& figure) const;
  /// The unknowns at any figure in the scene's frame: lengths of segments are positive.
  ComplexValues coordinates_as_drawn(const Figure& figure) const;
  /// At most so far are points, and lines and planes as SceneEquations::distance says, from where the unknowns put them
  /// that are off from x by these amounts. `x`: coordinates(figure).
  double distance(const Figure& figure, const ComplexValues& x, const std::vector<double>& offsets) const;
  /// How far elements of the figure are at most from where the unknowns, found from some of them, put them: points of a
  /// body that has another shape.
  double misfit(const Figure& figure) const;
  /// The figure at values of the unknowns or, where it is real, at their real parts.
  Figure figure(const ComplexValues& x, bool is_real) const;

 private:
  double farthest(const Figure& figure, const ComplexValues& x, const std::vector<double>& offsets,
                  double rounding) const;

  SystemBuilder builder_;
};

}  // namespace gcs
