#pragma once
/// The column kernels of one instruction set: rows of columns in lanes; see column_kernels.hpp.

#include <cmath>
#include <cstring>

#include "solvers/lanes/column_kernels.hpp"
#include "solvers/lanes/lanes.hpp"

namespace gcs::GCS_LANES {

inline Lanes load(const double* from) {
  Lanes lanes;
  std::memcpy(&lanes.v, from, sizeof lanes.v);
  return lanes;
}
inline void store(Lanes lanes, double* to) { std::memcpy(to, &lanes.v, sizeof lanes.v); }

/// Numbers that fill no vector.
inline Lanes load_some(const double* from, std::ptrdiff_t count) {
  Lanes lanes;
  for (int i = 0; i < count; ++i) lanes.set_lane(i, from[i]);
  return lanes;
}
inline void store_some(Lanes lanes, double* to, std::ptrdiff_t count) {
  for (int i = 0; i < count; ++i) to[i] = lanes.lane(i);
}

/// Vectors of rows of which the last ones may overlap, but none reaches beyond the rows.
template <int vectors>
class Strip {
 public:
  Strip(std::ptrdiff_t first, std::ptrdiff_t rows) {
    const std::ptrdiff_t last = rows - Lanes::count;
    for (std::ptrdiff_t& row : rows_) {
      row = first < last ? first : last;
      first += Lanes::count;
    }
  }

  Lanes at(const double* column, int vector) const { return load(column + rows_[vector]); }
  void put(Lanes value, double* column, int vector) const { store(value, column + rows_[vector]); }

 private:
  std::ptrdiff_t rows_[vectors];
};

/// All rows, where they are fewer than the lanes.
struct ShortStrip {
  std::ptrdiff_t rows = 0;

  Lanes at(const double* column, int) const { return load_some(column, rows); }
  void put(Lanes value, double* column, int) const { store_some(value, column, rows); }
};

/// Calls make(strip, number of its vectors as a constant) for strips that cover all rows.
template <class Make>
void for_each_strip(std::ptrdiff_t rows, const Make& make) {
  constexpr std::ptrdiff_t width = Lanes::count;
  if (rows < width) return make(ShortStrip{rows}, std::integral_constant<int, 1>{});
  std::ptrdiff_t row = 0;
  for (; row + 3 * width < rows; row += 4 * width)
    make(Strip<4>(row, rows), std::integral_constant<int, 4>{});
  for (; row + width < rows; row += 2 * width) make(Strip<2>(row, rows), std::integral_constant<int, 2>{});
  if (row < rows) make(Strip<1>(row, rows), std::integral_constant<int, 1>{});
}

inline void combine(const DenseColumns& columns, std::ptrdiff_t count, const double* factors,
                    double* result) {
  for_each_strip(columns.rows, [&](const auto& strip, auto vectors) {
    Lanes even[vectors] = {}, odd[vectors] = {};
    const double* column = columns.first;
    const auto add = [&](Lanes* sums, double factor) {
      const Lanes scale = constant(factor, Lanes{});
      for (int v = 0; v < vectors; ++v) sums[v] = sums[v] + scale * strip.at(column, v);
      column += columns.stride;
    };
    std::ptrdiff_t j = 0;
    for (; j + 1 < count; j += 2) {
      add(even, factors[j]);
      add(odd, factors[j + 1]);
    }
    if (j < count) add(even, factors[j]);
    for (int v = 0; v < vectors; ++v) strip.put(even[v] + odd[v], result, v);
  });
}

inline void evaluate(const DenseColumns& columns, std::ptrdiff_t count, const double* weights, double s,
                     double* result) {
  for_each_strip(columns.rows, [&](const auto& strip, auto vectors) {
    Lanes sums[vectors] = {};
    const Lanes at = constant(s, Lanes{});
    for (std::ptrdiff_t j = count; j-- > 0;) {
      const Lanes weight = constant(weights[j], Lanes{});
      const double* column = columns.first + j * columns.stride;
      for (int v = 0; v < vectors; ++v) sums[v] = sums[v] * at + weight * strip.at(column, v);
    }
    for (int v = 0; v < vectors; ++v) strip.put(sums[v], result, v);
  });
}

inline void half_convolution(const DenseColumns& columns, std::ptrdiff_t first, std::ptrdiff_t n,
                             double* result) {
  for_each_strip(columns.rows, [&](const auto& strip, auto vectors) {
    Lanes sums[vectors] = {};
    const double *a = columns.first + first * columns.stride,
                 *b = columns.first + (n - first) * columns.stride;
    for (; a < b; a += columns.stride, b -= columns.stride)
      for (int v = 0; v < vectors; ++v) sums[v] = sums[v] + strip.at(a, v) * strip.at(b, v);
    if (a == b) {
      const Lanes half = constant(0.5, Lanes{});
      for (int v = 0; v < vectors; ++v) sums[v] = sums[v] + half * strip.at(a, v) * strip.at(a, v);
    }
    for (int v = 0; v < vectors; ++v) strip.put(sums[v], result, v);
  });
}

inline void squares(const DenseColumns& columns, std::ptrdiff_t count, double* result) {
  for_each_strip(columns.rows, [&](const auto& strip, auto vectors) {
    Lanes sums[vectors] = {};
    const double* column = columns.first;
    for (std::ptrdiff_t j = 0; j < count; ++j, column += columns.stride)
      for (int v = 0; v < vectors; ++v) sums[v] = sums[v] + strip.at(column, v) * strip.at(column, v);
    for (int v = 0; v < vectors; ++v) strip.put(sums[v], result, v);
  });
}

inline void substitute(double* columns, std::ptrdiff_t stride, const ColumnStep* steps, std::ptrdiff_t count,
                       const int* sources, const double* factors) {
  for_each_strip(stride, [&](const auto& strip, auto vectors) {
    for (const ColumnStep* step = steps; step != steps + count; ++step) {
      double* target = columns + step->target * stride;
      Lanes sums[vectors];
      for (int v = 0; v < vectors; ++v) sums[v] = constant(step->scale, Lanes{}) * strip.at(target, v);
      for (int i = step->first; i < step->last; ++i) {
        const Lanes factor = constant(factors[i], Lanes{});
        const double* source = columns + sources[i] * stride;
        for (int v = 0; v < vectors; ++v) sums[v] = sums[v] - factor * strip.at(source, v);
      }
      for (int v = 0; v < vectors; ++v) strip.put(sums[v], target, v);
    }
  });
}

inline ColumnKernels column_kernels() { return {combine, evaluate, half_convolution, squares, substitute}; }

}  // namespace gcs::GCS_LANES
