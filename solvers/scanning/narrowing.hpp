#pragma once
/// What of a cell linear parts of forms leave.

#include "solvers/numeric/affine_form.hpp"

namespace gcs {

/// The part of a cell, in its own coordinates ξ in [−1, 1], on which a branch may still hold a solution.
template <int N>
class Narrowing {
 public:
  Narrowing() {
    low_.fill(-1);
    high_.fill(1);
  }

  /// Leaves what satisfies g = 0, or g ≥ 0. False when nothing does; where g is not a number, all may.
  bool by_zero(const AffineForm<N>& g) { return by_bound(g) && by_bound(-g); }
  bool by_bound(const AffineForm<N>& g) {
    for (int i = 0; i < N; ++i) {
      double others = g.mid + g.rest + 8 * AffineForm<N>::epsilon * (std::abs(g.mid) + g.radius());
      for (int j = 0; j < N; ++j)
        if (j != i) others += std::max(g.slope[j] * low_[j], g.slope[j] * high_[j]);
      // slope_i ξ_i ≥ −others
      if (g.slope[i] > 0) low_[i] = std::max(low_[i], -others / g.slope[i] - margin);
      if (g.slope[i] < 0) high_[i] = std::min(high_[i], -others / g.slope[i] + margin);
      if (!(low_[i] <= high_[i])) return false;
    }
    return !(g.high() < 0);
  }

  /// Leaves what of symbol i is between the bounds of `values`.
  bool by_values(int i, const AffineForm<N>& values) {
    low_[i] = std::max(low_[i], values.low());
    high_[i] = std::min(high_[i], values.high());
    return low_[i] <= high_[i];
  }

  /// What is left of symbol i.
  double low(int i) const { return low_[i]; }
  double high(int i) const { return high_[i]; }
  /// Symbol i now stands for something else.
  void reset(int i) {
    low_[i] = -1;
    high_[i] = 1;
  }

 private:
  static constexpr double margin = 1e-14;  ///< in ξ: more than the rounding of the division
  std::array<double, N> low_;
  std::array<double, N> high_;
};

}  // namespace gcs
