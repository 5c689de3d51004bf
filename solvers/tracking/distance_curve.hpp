#pragma once
/// S in full space, R^m × R, as the series tracker wants it ([I] §2.2, in squared lengths).

#include "solvers/lanes/sparse_inverse.hpp"
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
  void set(int n, const Eigen::Ref<const Eigen::VectorXd>& coefficient);
  void known(int n, Eigen::Ref<Eigen::VectorXd> result);
  double shortest_length(double t) const { return lengths_.shortest(t); }

  /// 1 where [dF/dx, dF/dt; tangent] may have an entry that is not 0.
  Eigen::MatrixXd bordered_pattern() const;

  /// In the frame.
  Figure figure(const Eigen::VectorXd& y) const { return system_.figure(y.head(unknowns())); }

 private:
  DistanceSystem system_;
  LengthSeries lengths_;
  EdgeSeries edges_;
  Figure sketch_;
  Eigen::Matrix3Xd points_;
  /// The difference of two coordinates, by axis and edge: numbers of unknowns, then of coordinates that the frame fixes.
  struct Difference {
    int minuend = 0;
    int subtrahend = 0;
    int equation = 0;
  };
  std::vector<Difference> differences_;
  Eigen::VectorXd coordinates_;  ///< unknowns and fixed ones
  Eigen::VectorXd moving_;       ///< one coefficient of both: 0 for fixed ones
};

class DistanceCurve : public ImplicitCurve<DistanceFamily, SparseInverse> {
 public:
  /// In the scene's frame. Precondition: the scene has a sketch and no lines.
  DistanceCurve(const Scene& scene, int order, double tolerance)
      : DistanceCurve(scene, scene.reference(), order, tolerance) {}
  /// In another one.
  DistanceCurve(const Scene& scene, const Reference& reference, int order, double tolerance)
      : DistanceCurve(DistanceFamily(scene, reference, order), tolerance) {}

  /// The figure of a tracker's point, in the frame.
  Figure figure(const Eigen::VectorXd& y) const { return family().figure(y); }

 private:
  DistanceCurve(const DistanceFamily& family, double tolerance)
      : ImplicitCurve(family, tolerance, SparseInverse(family.bordered_pattern())) {}
};

}  // namespace gcs
