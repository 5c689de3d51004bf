#pragma once
/// S of a general scene: all figures that meet what has no value, with the values on their way from those of the sketch
/// (t = 0) to the given ones (t = 1).
///
/// Lengths and offsets travel linearly in t but for those that are bent, angles by their cosine. A value with a sign goes
/// through 0. So does one that is the square of an unknown in the equations, such as the distance of two lines or the
/// cosine of their angle: the unknown itself, with the sign that it has in the sketch, takes its place. The others are
/// squares of what has no sign, and S ends before they vanish, where another problem would begin.
///
/// A line that has turned over when S is back at the sketch has other unknowns there, and S is closed all the same.

#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/tracking/edge_series.hpp"
#include "solvers/tracking/implicit_curve.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {

/// What the equations say of a value.
struct TravellingValue {
  LengthPath path;       ///< 0 where the equation has none
  bool is_plain = true;  ///< the equation has it, not half its square
  double root_sign = 0;  ///< of the form that takes the place of its square; 0: of none
};

class GeneralFamily {
 public:
  /// `sketched`: unknowns that meet the equations without a value.
  GeneralFamily(const Scene& scene, const SceneSystem& system, Eigen::VectorXd sketched, int order);

  int unknowns() const { return equations_.unknowns; }
  Eigen::VectorXd start() const { return with_time(sketched_, 0); }
  void residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f);
  void wide_residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f);
  void jacobian(const Eigen::VectorXd& y, Eigen::MatrixXd& matrix);
  void start_series(double t);
  void set(int n, const Eigen::Ref<const Eigen::VectorXd>& coefficient);
  void known(int n, Eigen::Ref<Eigen::VectorXd> result);
  double shortest_length(double t) const;

  const std::vector<TravellingValue>& values() const { return values_; }
  /// As TurnedCurve says: lines, planes and segments may be turned over.
  Eigen::VectorXd signs_towards(const Eigen::VectorXd& y0, const Eigen::VectorXd& y) const;

 private:
  void take_root(Eigen::Index equation);
  double side(Eigen::Index equation, double t) const;

  RealEquations equations_;
  std::vector<TravellingValue> values_;  ///< one per equation
  LengthSeries series_of_values_;
  Eigen::VectorXd sketched_;
  SignMasks signs_;
  SignMask turnings_;
  Eigen::MatrixXd left_, right_;  ///< (product, order): coefficients of their series
  Eigen::VectorXd convolution_;
};

class GeneralCurve : public ImplicitCurve<GeneralFamily> {
 public:
  using ImplicitCurve::ImplicitCurve;

  Eigen::VectorXd signs_towards(const Eigen::VectorXd& y0, const Eigen::VectorXd& y) const {
    return family().signs_towards(y0, y);
  }
};

}  // namespace gcs
