#pragma once
/// The extreme singular values of several complex matrices side by side.
///
/// Reflections from both sides make a matrix A bidiagonal, and only the moduli of its entries matter (Golub, Kahan 1965).
/// Whether an eigenvalue of AᴴA lies below x is read from the signs of the pivots of AᴴA − x, which the differential
/// quotient-difference algorithm gives to high relative accuracy (Dhillon, Parlett 2004); bisection finds the smallest
/// and the largest.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "solvers/lanes/complex_lanes.hpp"

namespace gcs::GCS_LANES {

inline Lanes square_root(Lanes a) {
  Lanes root;
  for (int i = 0; i < Lanes::count; ++i) root.v[i] = std::sqrt(a.v[i]);
  return root;
}

inline Lanes squared_modulus(const Complex<Lanes>& z) { return fused(z.re, z.re, z.im * z.im); }

/// 1 − factor·v·vᴴ, which turns a vector into a multiple of the first unit vector.
class Reflection {
 public:
  /// Of the vector in `v`, which is changed and must live as long as this.
  explicit Reflection(std::vector<Complex<Lanes>>& v) : v_(v) {
    for (const Complex<Lanes>& entry : v) squared_norm_ = squared_norm_ + squared_modulus(entry);
    const Lanes zero{}, one = constant(1, Lanes{});
    const Lanes norm = square_root(squared_norm_), first = square_root(squared_modulus(v[0]));
    const Lanes is_first = is_less(zero, first), is_vector = is_less(zero, squared_norm_);
    const Lanes scale = norm / selected(is_first, first, one);
    v[0] = {v[0].re + selected(is_first, scale * v[0].re, norm), fused(scale, v[0].im, v[0].im)};
    factor_ = selected(is_vector, one / selected(is_vector, norm * (norm + first), one), zero);
  }

  Lanes squared_norm() const { return squared_norm_; }

  /// To the vector whose entries entry(0), entry(1), … refer to.
  template <class Entry>
  void apply(const Entry& entry) const {
    std::array<Lanes, 4>
        sums{};  // of the parts of conj(v)·entry: sums of one product each wait for each other least
    for (std::size_t i = 0; i < v_.size(); ++i) {
      const Complex<Lanes> v = v_[i], x = entry(i);
      sums[0] = fused(v.re, x.re, sums[0]);
      sums[1] = fused(v.im, x.im, sums[1]);
      sums[2] = fused(v.re, x.im, sums[2]);
      sums[3] = fused(v.im, x.re, sums[3]);
    }
    const Complex<Lanes> share = factor_ * Complex<Lanes>(sums[0] + sums[1], sums[2] - sums[3]);
    for (std::size_t i = 0; i < v_.size(); ++i) entry(i) = fused_minus(share, v_[i], entry(i));
  }

 private:
  const std::vector<Complex<Lanes>>& v_;
  Lanes squared_norm_{};
  Lanes factor_;
};

class LaneMatrix {
 public:
  /// Precondition: both are at least 1.
  LaneMatrix(int rows, int columns)
      : is_wide_(rows < columns),
        rows_(static_cast<std::size_t>(std::max(rows, columns))),
        columns_(static_cast<std::size_t>(std::min(rows, columns))),
        entries_(rows_ * columns_),
        diagonal_(columns_),
        beside_(columns_) {}

  Complex<Lanes>& entry(std::size_t row, std::size_t column) {
    return is_wide_ ? kept(column, row) : kept(row, column);
  }

  void clear() {
    for (Complex<Lanes>& value : entries_) value = {{}, {}};
  }

  /// Of the largest singular value to the smallest; infinite where it is above 1e18 or so. The entries are
  /// lost. Precondition: no square of one overflows.
  Lanes singular_ratio() {
    make_bidiagonal();
    return bidiagonal_ratio();
  }

 private:
  Complex<Lanes>& kept(std::size_t row, std::size_t column) { return entries_[column * rows_ + row]; }

  /// Keeps the squares of the entries on the diagonal and above it.
  void make_bidiagonal() {
    for (std::size_t k = 0; k < columns_; ++k) {
      diagonal_[k] = reflect(rows_ - k, columns_ - k, [&](std::size_t i, std::size_t j) -> Complex<Lanes>& {
        return kept(k + i, k + j);
      });
      if (k + 1 == columns_) return;
      beside_[k] = reflect(columns_ - k - 1, rows_ - k, [&](std::size_t i, std::size_t j) -> Complex<Lanes>& {
        return kept(k + j, k + 1 + i);
      });
    }
  }

  /// Turns vector 0 of so many, at(i, j) being entry i of vector j, and the others with it; its squared norm.
  template <class At>
  Lanes reflect(std::size_t length, std::size_t vectors, const At& at) {
    reflected_.resize(length);
    for (std::size_t i = 0; i < length; ++i) reflected_[i] = at(i, 0);
    const Reflection reflection(reflected_);
    for (std::size_t j = 1; j < vectors; ++j)
      reflection.apply([&](std::size_t i) -> Complex<Lanes>& { return at(i, j); });
    return reflection.squared_norm();
  }

  /// Square roots of the largest x below which there is no eigenvalue, and not all.
  Lanes bidiagonal_ratio() const {
    constexpr double least = 0x1p-126;  // of the sum of all eigenvalues
    constexpr int doublings = 7, halvings = 52;
    Lanes sum{};
    for (std::size_t k = 0; k < columns_; ++k) sum = sum + diagonal_[k] + beside_[k];
    std::array<Lanes, 2> low{constant(least, Lanes{}) * sum, constant(least, Lanes{}) * sum};
    const Lanes is_singular = pivots_below(low)[0];
    const auto raise = [&](const std::array<Lanes, 2>& tried) {
      const std::array<Lanes, 2> is_high = pivots_below(tried);
      for (std::size_t which = 0; which < 2; ++which)
        low[which] = selected(is_high[which], low[which], tried[which]);
    };
    for (int i = doublings - 1; i >= 0; --i) {
      const Lanes factor = constant(std::ldexp(1.0, 1 << i), Lanes{});
      raise({factor * low[0], factor * low[1]});
    }
    std::array<Lanes, 2> step = low;
    for (int i = 0; i < halvings; ++i) {
      for (Lanes& half : step) half = constant(0.5, Lanes{}) * half;
      raise({low[0] + step[0], low[1] + step[1]});
    }
    return square_root(low[1] / selected(is_singular, {}, low[0]));
  }

  /// Whether there is an eigenvalue below x[0], and whether all are below x[1].
  std::array<Lanes, 2> pivots_below(const std::array<Lanes, 2>& x) const {
    constexpr double smallest_pivot = 1e-290;
    const Lanes zero{}, tiny = constant(smallest_pivot, Lanes{});
    std::array<Lanes, 2> shift{-x[0], -x[1]}, answer{zero, constant(1, Lanes{})};
    for (std::size_t k = 0; k < columns_; ++k)
      for (std::size_t which = 0; which < 2; ++which) {
        Lanes pivot = diagonal_[k] + shift[which];
        pivot = selected(is_less(absolute(pivot), tiny), -tiny, pivot);
        const Lanes is_below = is_less(pivot, zero);
        answer[which] = which == 0 ? larger(answer[0], is_below) : answer[1] * is_below;
        shift[which] = fused(shift[which], beside_[k] / pivot, -x[which]);
      }
    return answer;
  }

  bool is_wide_;  ///< then its transpose is kept, which has the same singular values
  std::size_t rows_, columns_;
  std::vector<Complex<Lanes>> entries_;
  std::vector<Lanes> diagonal_, beside_;
  std::vector<Complex<Lanes>> reflected_{};
};

}  // namespace gcs::GCS_LANES
