#pragma once
/// A scene as it is explored: its equations in doubles, which of them give a value, and its figures as unknowns.

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/quadratic_system.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/numeric/sign_masks.hpp"
#include "solvers/tracking/path_report.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {

/// Whether the equations are those of all kinds of elements: those of free points, and of a line that the frame holds, know
/// no given positions.
bool is_explored_by_elements(const Scene& scene);

/// Why there are no equations to explore, in a sentence; nothing where there are.
std::optional<std::string> why_not_explored(const Scene& scene);

class ExploredScene {
 public:
  virtual ~ExploredScene() = default;
  /// In any position.
  virtual Eigen::VectorXd unknowns(const Figure& figure) const = 0;

  /// With the file's numbers, and in doubles.
  const QuadraticSystem& exact() const { return exact_; }
  const RealEquations& equations() const { return equations_; }
  /// Changes of signs that lead to the same figure.
  const SignMasks& signs() const { return signs_; }
  /// Of each equation the value that it gives, counted as constraints and then relations; negative: none.
  const std::vector<int>& value_of() const { return value_of_; }
  /// At the given values.
  const TargetEquations& target() const { return *target_; }

 protected:
  explicit ExploredScene(QuadraticSystem exact)
      : exact_(std::move(exact)), equations_(real_equations(exact_)), signs_(exact_.mirror) {}

  QuadraticSystem exact_;
  RealEquations equations_;
  SignMasks signs_;
  std::vector<int> value_of_;
  std::unique_ptr<TargetEquations> target_;
};

/// Precondition: !why_not_explored(scene). The scene outlives it.
std::unique_ptr<ExploredScene> explored_scene(const Scene& scene);

}  // namespace gcs
