#pragma once
/// What a step along one path is made of, on columns of doubles, in the widest instructions of the machine. Every number is
/// made by the same operations in the same order whatever they are, so that its bits do not depend on them.

#include <cstddef>
#include <vector>

namespace gcs {

/// Columns of so many rows, one after the other at distances of `stride` ≥ rows.
struct DenseColumns {
  const double* first = nullptr;
  std::ptrdiff_t stride = 0;
  std::ptrdiff_t rows = 0;
};

/// Columns of numbers, 0 at first, at distances and places at which the widest vectors lie within lines of the cache. A block
/// behind the last, so that the place of a column exists also where there is none.
class AlignedColumns {
 public:
  AlignedColumns() = default;
  AlignedColumns(std::ptrdiff_t rows, std::ptrdiff_t columns)
      : rows_(rows),
        blocks_((rows + block - 1) / block),
        numbers_(static_cast<std::size_t>(blocks_ * columns + 1)) {}

  std::ptrdiff_t stride() const { return blocks_ * block; }
  double* column(std::ptrdiff_t j) { return numbers_[j * blocks_].numbers; }
  const double* column(std::ptrdiff_t j) const { return numbers_[j * blocks_].numbers; }
  /// From that column on.
  DenseColumns from(std::ptrdiff_t j) const { return {column(j), stride(), rows_}; }

 private:
  static constexpr int block = 8;
  struct alignas(block * sizeof(double)) Block {
    double numbers[block] = {};
  };

  std::ptrdiff_t rows_ = 0, blocks_ = 0;
  std::vector<Block> numbers_;
};

/// Σ factors[i] · column sources[i] over first ≤ i < last, to be taken from `scale` · column target.
struct ColumnStep {
  int target = 0;
  int first = 0, last = 0;
  double scale = 1;
};

struct ColumnKernels {
  /// Σ_j factors[j] · column j, over `count` columns.
  void (*combine)(const DenseColumns& columns, std::ptrdiff_t count, const double* factors, double* result);
  /// Σ_j weights[j] s^j · column j, over `count` columns, by Horner's rule.
  void (*evaluate)(const DenseColumns& columns, std::ptrdiff_t count, const double* weights, double s,
                   double* result);
  /// ½ Σ_i column i · column n − i, row by row, i from `first` to n − `first`.
  void (*half_convolution)(const DenseColumns& columns, std::ptrdiff_t first, std::ptrdiff_t n,
                           double* result);
  /// Σ_j (column j)², row by row, over `count` columns.
  void (*squares)(const DenseColumns& columns, std::ptrdiff_t count, double* result);
  /// All steps, in their order, on the columns themselves, of `stride` rows, a multiple of 8. Precondition: no column is its
  /// own source.
  void (*substitute)(double* columns, std::ptrdiff_t stride, const ColumnStep* steps, std::ptrdiff_t count,
                     const int* sources, const double* factors);
};

}  // namespace gcs
