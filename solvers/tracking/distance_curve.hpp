#pragma once
/// S in full space, R^m × R, as the series tracker wants it ([I] §2.2, in squared lengths).

#include "solvers/model/distance_system.hpp"
#include "solvers/tracking/edge_series.hpp"
#include "solvers/tracking/implicit_curve.hpp"

namespace gcs {

/// f(x, t), half squares: |p_a − p_b|²/2 − a(t)²/2.
class DistanceFamily {
 public:
  /// Precondition: the scene has a sketch and no lines.
  DistanceFamily(const Scene& scene, const Reference& reference, int order);

  int unknowns() const { return system_.unknowns(); }
  Eigen::VectorXd start() const { return with_time(system_.coordinates(sketch_), 0); }
  void residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f);
  void wide_residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f);
  void jacobian(const Eigen::VectorXd& y, Eigen::MatrixXd& matrix);
  void start_series(double t) { lengths_.start(t); }
  void set(int n, const Eigen::VectorXd& coefficient);
  void known(int n, Eigen::Ref<Eigen::VectorXd> result);
  double shortest_length(double t) const { return lengths_.shortest(t); }

  /// In the frame.
  Figure figure(const Eigen::VectorXd& y) const { return system_.figure(y.head(unknowns())); }

 private:
  DistanceSystem system_;
  LengthSeries lengths_;
  EdgeSeries edges_;
  Figure sketch_;
  Eigen::Matrix3Xd points_;
  Eigen::Matrix3Xd moving_;  ///< one coefficient as a figure: zero where the frame fixes a coordinate
  Eigen::VectorXd half_convolution_;
};

class DistanceCurve : public ImplicitCurve<DistanceFamily> {
 public:
  /// In the scene's frame. Precondition: the scene has a sketch and no lines.
  DistanceCurve(const Scene& scene, int order, double tolerance)
      : DistanceCurve(scene, scene.reference(), order, tolerance) {}
  /// In another one.
  DistanceCurve(const Scene& scene, const Reference& reference, int order, double tolerance)
      : ImplicitCurve(DistanceFamily(scene, reference, order), tolerance) {}

  /// The figure of a tracker's point, in the frame.
  Figure figure(const Eigen::VectorXd& y) const { return family().figure(y); }
};

}  // namespace gcs
