#pragma once
/// S in full space, R^m × R, as the series tracker wants it ([I] §2.2, in squared lengths).

#include <Eigen/LU>

#include "solvers/model/distance_system.hpp"
#include "solvers/numeric/arc_series.hpp"
#include "solvers/running/work.hpp"
#include "solvers/tracking/edge_series.hpp"

namespace gcs {

class DistanceCurve {
 public:
  /// In the scene's frame. Precondition: the scene has a sketch and no lines.
  DistanceCurve(const Scene& scene, int order, double tolerance);
  /// In another one.
  DistanceCurve(const Scene& scene, const Reference& reference, int order, double tolerance);

  Eigen::Index coordinates() const { return system_.unknowns() + 1; }
  bool start(int orientation, ArcSeries& series);
  bool advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series);
  void renew(ArcSeries& series);
  double shortest_length(double t) const { return lengths_.shortest(t); }
  void accept() {}
  void reject() {}
  WorkCounters& work() { return work_; }

  /// The figure of a tracker's point, in the frame.
  Figure figure(const Eigen::VectorXd& y) const { return system_.figure(y.head(system_.unknowns())); }
  /// f(y), half squares: |p_a − p_b|²/2 − a(t)²/2.
  void residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f);
  /// [df/dx, df/dt] at y into the first rows of the bordered matrix.
  void jacobian(const Eigen::VectorXd& y);

 private:
  void factorise(const Eigen::VectorXd& y, const Eigen::VectorXd& last_row);
  void expand(const Eigen::VectorXd& y, ArcSeries& series);
  void set_differences(int n, const ArcSeries& series);

  DistanceSystem system_;
  LengthSeries lengths_;
  EdgeSeries edges_;
  double tolerance_;
  Figure sketch_;
  Eigen::Matrix3Xd points_;
  Eigen::Matrix3Xd moving_;  ///< one coefficient as a figure: zero where the frame fixes a coordinate
  Eigen::MatrixXd bordered_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
  int side_ = 0;  ///< the sign of the bordered matrix's determinant, on all of S
  Eigen::VectorXd right_side_, correction_, half_convolution_;
  WorkCounters work_;
};

}  // namespace gcs
