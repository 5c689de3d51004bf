#pragma once
/// The interpolation functions a_i(t) of [I] Definition 1.

#include <cmath>
#include <limits>
#include <vector>

#include "solvers/numeric/double_double.hpp"

namespace gcs {

/// a(t) = (1 − t)·at_sketch + t·at_target + t(1 − t)·(bend + higher[0]·t + higher[1]·t² + …), in one unit of
/// length; t has none. Without `higher` it is [I]'s −bend·t² + (at_target − at_sketch + bend)·t + at_sketch, and
/// with bend = 0 linear.
struct LengthPath {
  double at_sketch = 0;
  double at_target = 0;
  double bend = 0;
  std::vector<double> higher{};  ///< does not end in 0

  /// Exact at t = 0 and t = 1.
  double value(double t) const {
    const double quadratic = (1 - t) * at_sketch + t * at_target + bend * t * (1 - t);
    return higher.empty() ? quadratic : quadratic + higher_value(t);
  }
  /// value(t), right to some 2^-104 of its terms.
  DoubleDouble wide_value(double t) const;
  double slope(double t) const {
    const double linear = at_target - at_sketch + bend * (1 - 2 * t);
    return higher.empty() ? linear : linear + higher_slope(t);
  }

  /// An upper bound on the degree of the polynomial; at least 2.
  int degree() const { return static_cast<int>(higher.size()) + 2; }
  /// a(t + τ) = Σ result[k]·τ^k up to the degree. In floating point each is off by less than
  /// (4·degree + 16)·ε of expansion_sizes(t)[k].
  std::vector<double> expansion(double t) const;
  /// The same sums with every parameter and every power of t by its size: what the coefficients change by where
  /// no parameter changes by more than this one.
  std::vector<double> expansion_sizes(double t) const;

 private:
  double higher_value(double t) const;
  double higher_slope(double t) const;
};

struct TimeRange {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool is_bounded() const { return std::isfinite(low) && std::isfinite(high); }
};

/// The part of supp+(a) ([I] Definition 1: all lengths are ≥ 0) that holds [0, 1], in which the t of S stays, to
/// rounding. Bounded on both sides: (h2) holds for S, which is closed where it is regular. A length that is the
/// same at both ends but for rounding is taken not to change.
/// Precondition: the lengths are positive on [0, 1].
TimeRange positive_support(const std::vector<LengthPath>& lengths);

/// Where S goes beyond this it is said to run off to infinity: to a side on which the positive support has no end,
/// so far that every length is its leading term to a thousandth or so. Elsewhere infinite.
TimeRange times_far_away(const std::vector<LengthPath>& lengths);

}  // namespace gcs
