#pragma once
/// Solutions of general scenes settled with the file's own numbers.

#include "solvers/certificates/ball_krawczyk.hpp"
#include "solvers/elements/scene_system.hpp"

namespace gcs {

/// Newton's method with residuals in high precision, which brings a figure in doubles to rounding, where residuals in
/// doubles leave it the condition number times that away (Wilkinson's iterative refinement).
class FigureSettler {
 public:
  /// Precondition: !why_no_system(scene). The scene outlives this.
  explicit FigureSettler(const Scene& scene);

  /// The figure, in the scene's frame, with its unknowns moved to the solution next to it; as it is where the equations
  /// are not as many as the unknowns, or where Newton's steps do not shrink or are longer than rounding explains. Time:
  /// cubic in the unknowns.
  Figure settled(const Figure& figure) const;

 private:
  SceneSystem system_;
  BallKrawczyk equations_;
};

}  // namespace gcs
