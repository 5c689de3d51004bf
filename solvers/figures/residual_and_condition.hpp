#pragma once
/// How good a figure is as a solution, judged from the figure alone.

#include <memory>

#include "solvers/model/scene.hpp"

namespace gcs {

class GeneralJudge;
class SceneSystem;

/// max over the constraints of |distance − length| / max(length, scene size · 1e-3), with the distance
/// evaluated in double-double so that the number says something about the figure and not about the
/// evaluation. Dimensionless.
double relative_residual(const Scene& scene, const Figure& figure);

/// A relative residual up to this is that of a double solution which the rounding of the lengths leaves 1e-8
/// away: its distances, which vary with the square, are right to rounding.
inline constexpr double double_root_residual = 1e-13;

/// 2-norm condition number of the Jacobian of the distances at the figure, its rows normalised, in the
/// frame's free coordinates; to as many digits as rounding leaves, in general scenes to seven at most.
/// Above 300 unknown coordinates of points an estimate from below (sparse_condition.hpp). Infinity at a
/// singular figure. Dimensionless.
double jacobian_condition(const Scene& scene, const Figure& figure);

/// A solution with a condition number from here on is stiff: which one it is takes a proof.
inline constexpr double stiff_condition = 1e6;

/// The two of many figures of one scene, whose equations are set up once.
class FigureJudge {
 public:
  /// Keeps a reference to the scene.
  explicit FigureJudge(const Scene& scene);
  /// The same with the scene's system, to which a reference is kept.
  explicit FigureJudge(const SceneSystem& system);

  double residual(const Figure& figure) const;   ///< see relative_residual
  double condition(const Figure& figure) const;  ///< see jacobian_condition
  /// The equations of a general scene that has some; null otherwise.
  const SceneSystem* system() const;
  /// condition(figure) ≥ stiff_condition, in a tenth of the time where it is far below.
  bool is_stiff(const Figure& figure) const;

 private:
  bool may_be_stiff(const Figure& figure) const;

  const Scene& scene_;
  std::shared_ptr<const SceneSystem> system_;    ///< null where it was given
  std::shared_ptr<const GeneralJudge> general_;  ///< of a general scene that has a system
};

/// See FigureJudge.
bool is_stiff(const Scene& scene, const Figure& figure);

/// The size to which the rounding of a figure's distances is relative: the largest coordinate in modulus, and
/// for a line how far it is from the points, times the 2-norm of its direction (1 when it is real). Infinite
/// or not a number where the figure is.
double extent(const Figure& figure);

/// Whether coordinates are so large that their rounding to doubles moves a squared distance of the scene's
/// size by as much as it is.
bool loses_distances(const Scene& scene, const Figure& figure);

}  // namespace gcs
