#pragma once
/// The part of the distance equations' Taylor series that every tracker of S shares. With points and t as
/// series in s, the n-th coefficient of (|p_a − p_b|² − a(t)²)/2 is
///   (p_a − p_b)_0 · (p_a − p_b)_n − a·a'(t_0)·t_n + constant_n,
/// linear in the n-th coefficients; constant_n depends on lower ones only.

#include <Eigen/Core>
#include <array>
#include <utility>
#include <vector>

#include "solvers/lanes/column_kernels.hpp"
#include "solvers/lanes/lane_functions.hpp"
#include "solvers/model/interpolation.hpp"

namespace gcs {

/// (|p_a − p_b|² − a(t)²)/2 of an edge between these columns.
inline double half_excess(const Eigen::Matrix3Xd& points, const std::array<int, 2>& edge,
                          const LengthPath& path, double t) {
  const double length = path.value(t);
  return ((points.col(edge[0]) - points.col(edge[1])).squaredNorm() - length * length) / 2;
}
/// The same, right but for the last rounding also where the difference is small.
double wide_half_excess(const Eigen::Matrix3Xd& points, const std::array<int, 2>& edge,
                        const LengthPath& path, double t);

/// Series of a(t(s))²/2 for all lengths. With a(t) of degree two at most, as nearly always, they are made for all
/// lengths at once from (t − t0)², (t − t0)³ and (t − t0)⁴; the others are made one by one.
class LengthSeries {
 public:
  LengthSeries(std::vector<LengthPath> paths, int order) : LengthSeries(std::move(paths), {}, order) {}
  /// The same where a(t(s)) itself is meant by those that are marked as `plain`; empty: by none.
  LengthSeries(std::vector<LengthPath> paths, std::vector<bool> plain, int order);

  /// Expands about t0. Afterwards value(i) = a_i(t0), slope(i) = a_i·a_i'(t0), or a_i'(t0) of a plain one.
  void start(double t0);
  double value(Eigen::Index i) const { return value_[i]; }
  double slope(Eigen::Index i) const { return slope_[i]; }
  /// The least of the lengths at t, each relative to what it is at the sketch or the target, whichever is
  /// more.
  double shortest(double t) const;
  const std::vector<LengthPath>& paths() const { return paths_; }

  /// To be called for n = 1, 2, … once t_n is known.
  void set(int n, double t_n) { offset_[n] = t_n; }
  /// The n-th coefficient of a_i²/2, or of a plain a_i, without the term slope(i)·t_n. Precondition: set up to n − 1.
  void known(int n, Eigen::Ref<Eigen::VectorXd> result);

 private:
  std::vector<LengthPath> paths_;
  std::vector<bool> plain_;
  Eigen::VectorXd value_, slope_, quadratic_, cubic_, quartic_;  // a²/2 in powers of t − t0
  Eigen::VectorXd offset_, offset2_;                             // series of t − t0 and (t − t0)²

  /// A length of a higher degree.
  struct Polynomial {
    Eigen::Index edge = 0;
    std::vector<double> powers;  ///< a²/2, or a plain a, in powers of t − t0
  };
  void expand(Polynomial& of, double t0) const;
  void set_powers(int n);

  std::vector<Polynomial> polynomials_;
  Eigen::MatrixXd powers_;  ///< (k, n): coefficient n of (t − t0)^k; no rows where no length needs them
};

/// Differences of the end points of all edges as series. All axes of one order are one array, so that the
/// convolution, the costliest loop of a step, runs over axes and edges at once.
class EdgeSeries {
 public:
  EdgeSeries(Eigen::Index edges, int dimension, int order);

  void resize(Eigen::Index edges);
  Eigen::Index edges() const { return products_.size() / dimension_; }
  /// The n-th coefficients of (p_a − p_b): entry axis · edges + edge.
  auto difference(int n) { return Eigen::Map<Eigen::VectorXd>(differences_.column(n), products_.size()); }
  /// Takes ½ Σ_{i=1}^{n−1} d_i·d_{n−i} from the entry of every edge.
  void subtract_half_convolution(int n, Eigen::Ref<Eigen::VectorXd> entries);

 private:
  int dimension_;
  int order_;
  AlignedColumns differences_;
  Eigen::VectorXd products_;
  ColumnKernels kernels_ = lane_functions().columns;
};

}  // namespace gcs
