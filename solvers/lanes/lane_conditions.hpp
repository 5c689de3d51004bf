#pragma once
/// Condition numbers of several matrices of differences; see distance_conditions.hpp.

#include <algorithm>
#include <span>

#include "solvers/lanes/distance_conditions.hpp"
#include "solvers/lanes/lane_singular_values.hpp"

namespace gcs::GCS_LANES {

/// The differences of the entries, of as many figures as there are lanes; the last figure fills the lanes that are left.
inline void take_differences(const DifferenceMatrix& pattern, std::span<const PointCoordinates> figures,
                             LaneMatrix& matrix) {
  matrix.clear();
  for (int lane = 0; lane < Lanes::count; ++lane) {
    const auto [real, imaginary] = figures[std::min<std::size_t>(lane, figures.size() - 1)];
    for (const auto& [row, column, minuend, subtrahend] : pattern.entries) {
      Complex<Lanes>& entry = matrix.entry(row, column);
      entry.re.set_lane(lane, real[minuend] - real[subtrahend]);
      if (imaginary != nullptr) entry.im.set_lane(lane, imaginary[minuend] - imaginary[subtrahend]);
    }
  }
}

/// Rows of norm 1, but for those that are 0. A row's largest part is divided out before its entries are squared.
inline void normalise_rows(const DifferenceMatrix& pattern, LaneMatrix& matrix) {
  const auto in_row = [&](auto first, auto last, const auto& take) {
    for (auto entry = first; entry != last; ++entry) take(matrix.entry(entry->row, entry->column));
  };
  const Lanes one = constant(1, Lanes{});
  for (auto first = pattern.entries.begin(); first != pattern.entries.end();) {
    const auto last = std::find_if(first, pattern.entries.end(), [&](const DifferenceMatrix::Entry& entry) {
      return entry.row != first->row;
    });
    Lanes largest{}, square{};
    in_row(first, last, [&](const Complex<Lanes>& entry) { largest = larger(size_of(entry), largest); });
    const Lanes scale = one / selected(largest, largest, one);
    in_row(first, last, [&](Complex<Lanes>& entry) {
      entry = scale * entry;
      square = square + squared_modulus(entry);
    });
    const Lanes factor = one / square_root(selected(square, square, one));
    in_row(first, last, [&](Complex<Lanes>& entry) { entry = factor * entry; });
    first = last;
  }
}

inline void conditions_of(const DifferenceMatrix& pattern, std::span<const PointCoordinates> figures,
                          double* conditions) {
  LaneMatrix matrix(pattern.rows, pattern.columns);
  while (!figures.empty()) {
    take_differences(pattern, figures, matrix);
    normalise_rows(pattern, matrix);
    const Lanes ratio = matrix.singular_ratio();
    const std::size_t some = std::min<std::size_t>(Lanes::count, figures.size());
    for (std::size_t i = 0; i < some; ++i) *conditions++ = ratio.lane(static_cast<int>(i));
    figures = figures.subspan(some);
  }
}

}  // namespace gcs::GCS_LANES
