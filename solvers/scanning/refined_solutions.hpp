#pragma once
/// Which ends of Newton's method are the same, while a scan goes on.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace gcs {

/// Relative to the scene's size. Newton's method ends at the same solution to about 1e-15 times its
/// condition.
inline constexpr double same_solution = 1e-9;

/// Distinct ends of Newton's method, in the order in which they came.
class RefinedSolutions {
 public:
  /// `axes`: see mirror_axes; −1 for all: mirror images are two.
  RefinedSolutions(std::vector<int> axes, double tolerance) : axes_(std::move(axes)), tolerance_(tolerance) {}

  void take(const Eigen::VectorXd& x) {
    const double reach = x.lpNorm<1>();
    const double slack = tolerance_ * static_cast<double>(x.size());
    for (auto other = by_reach_.lower_bound(reach - slack);
         other != by_reach_.end() && other->first <= reach + slack; ++other)
      if (is_same(x, list_[other->second])) return;
    by_reach_.emplace(reach, list_.size());
    list_.push_back(x);
  }
  const std::vector<Eigen::VectorXd>& list() const { return list_; }

 private:
  bool is_same(const Eigen::VectorXd& x, const Eigen::VectorXd& y) const {
    for (int axis = -1; axis < 3; ++axis) {
      double apart = 0, apart_mirrored = 0;
      for (Eigen::Index i = 0; i < x.size(); ++i) {
        if (axes_[static_cast<std::size_t>(i)] != axis) continue;
        apart = std::max(apart, std::abs(x[i] - y[i]));
        apart_mirrored = std::max(apart_mirrored, std::abs(x[i] + y[i]));
      }
      if (apart > tolerance_ && (axis < 0 || apart_mirrored > tolerance_)) return false;
    }
    return true;
  }

  std::vector<int> axes_;
  double tolerance_;
  std::vector<Eigen::VectorXd> list_;
  std::multimap<double, std::size_t> by_reach_;  ///< Σ |x_i|, equal for equal ones
};

}  // namespace gcs
