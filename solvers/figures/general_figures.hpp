#pragma once
/// How good a figure is as a solution of a general scene, and which are the same.

#include <limits>
#include <span>
#include <vector>

#include "solvers/elements/dense_equations.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/figures/reflection_classes.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

/// Judges figures of one general scene by its equations.
class GeneralJudge {
 public:
  /// Keeps a reference to the system.
  explicit GeneralJudge(const SceneSystem& system) : system_(system), equations_(system.equations()) {}

  const SceneSystem& system() const { return system_; }
  /// The largest |left − right| of an equation of the scene, relative to the sizes of its terms together or, where these
  /// are smaller, to a thousandth of the scene's unit, or misfit of a body's elements, relative to the scene's size.
  /// Dimensionless.
  double residual(const Figure& figure) const;
  /// The Jacobian of the scene's equations at the figure, its rows normalised.
  Eigen::MatrixXcd jacobian(const Figure& figure) const;
  /// Its 2-norm condition number, to seven digits at most. Infinite at a singular figure.
  double condition(const Figure& figure) const;

 private:
  const SceneSystem& system_;
  DenseEquations equations_;
};

/// Whether all imaginary parts are 0.
bool is_real(const Eigen::MatrixXcd& matrix);

/// How far unknowns of figures of one class may be apart.
struct GeneralTolerance {
  double relative = 0;  ///< to the largest unknown, at least 1
  double error =
      std::numeric_limits<double>::infinity();  ///< see Candidate::error; less than that where it is proven
};

/// Two figures are the same class when no unknown of the scene's equations differs by more than the tolerance after some
/// change of signs. Of two tolerances, one for each figure, the larger counts. No complex figure equals a real one. n² for n
/// figures, with early exits.
ReflectionClasses general_classes(const Scene& scene, std::span<const Figure> figures,
                                  std::span<const GeneralTolerance> tolerances);

}  // namespace gcs
