#pragma once
/// Solutions of general scenes settled with the file's own numbers.

#include "solvers/certificates/interval_equations.hpp"
#include "solvers/elements/scene_system.hpp"

namespace gcs {

/// Newton's method with residuals in double-double, which brings a figure in doubles to rounding, where residuals in
/// doubles leave it the condition number times that away (Wilkinson's iterative refinement).
class FigureSettler {
 public:
  /// Keeps a reference to the system.
  explicit FigureSettler(const SceneSystem& system);

  /// The figure, in the scene's frame, with its unknowns moved to the solution next to it; as it is where the equations
  /// are not as many as the unknowns, or where Newton's steps do not shrink or are longer than rounding explains.
  /// `condition`: jacobian_condition. Time: cubic in the unknowns.
  Figure settled(const Figure& figure, double condition) const;

 private:
  const SceneSystem& system_;
  IntervalEquations equations_;
};

}  // namespace gcs
