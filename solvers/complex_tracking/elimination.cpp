#include "solvers/complex_tracking/elimination.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <limits>

namespace gcs {
namespace {

using Pattern = Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>;

Eigen::MatrixXcd jacobian_at(const SquareSystem& system, const ComplexVectorX& x) {
  Eigen::MatrixXcd jacobian = Eigen::MatrixXcd::Zero(system.equations(), system.unknowns);
  for (int e = 0; e < system.equations(); ++e) {
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [minuend, subtrahend, constant] = system.differences[d];
      const std::complex<double> difference = x[minuend] - (subtrahend < 0 ? constant : x[subtrahend]);
      jacobian(e, minuend) = difference;
      if (subtrahend >= 0) jacobian(e, subtrahend) = -difference;
    }
    for (int l = system.first_linear[e]; l < system.first_linear[e + 1]; ++l)
      jacobian(e, system.linear[l].unknown) = system.linear[l].coefficient / 2.0;
  }
  return jacobian;
}

Pattern pattern_of(const SquareSystem& system) {
  Pattern pattern = Pattern::Constant(system.equations(), system.unknowns, false);
  for (int e = 0; e < system.equations(); ++e) {
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      pattern(e, system.differences[d].minuend) = true;
      if (system.differences[d].subtrahend >= 0) pattern(e, system.differences[d].subtrahend) = true;
    }
    for (int l = system.first_linear[e]; l < system.first_linear[e + 1]; ++l)
      pattern(e, system.linear[l].unknown) = true;
  }
  return pattern;
}

/// Eliminates the same pattern at several placements at once and picks the pivots.
class PivotSearch {
 public:
  PivotSearch(const SquareSystem& system, std::mt19937_64& random) : pattern_(pattern_of(system)) {
    constexpr int samples = 6;
    for (int i = 0; i < samples; ++i)
      samples_.push_back(jacobian_at(system, random_complex_vector(system.unknowns, random)));
    row_is_open_.assign(system.unknowns, true);
    column_is_open_.assign(system.unknowns, true);
  }

  /// Row and column of the next pivot, which is then eliminated.
  std::array<int, 2> next() {
    const auto [row, column] = choose();
    row_is_open_[row] = column_is_open_[column] = false;
    for (int i = 0; i < pattern_.rows(); ++i)
      if (row_is_open_[i] && pattern_(i, column)) eliminate(i, row, column);
    return {row, column};
  }

  /// With the fill of all steps done.
  const Pattern& pattern() const { return pattern_; }

 private:
  /// Smallest pivot beside the largest entry of its row: growth by 20 a step at the samples, at worst.
  static constexpr double least_ratio = 0.05;

  std::array<int, 2> choose() const {
    std::array<int, 2> best{-1, -1};
    double best_cost = std::numeric_limits<double>::infinity(), best_ratio = 0;
    for (int i = 0; i < pattern_.rows(); ++i) {
      if (!row_is_open_[i]) continue;
      for (int j = 0; j < pattern_.cols(); ++j) {
        if (!column_is_open_[j] || !pattern_(i, j)) continue;
        const double ratio = smallest_ratio(i, j);
        const double cost = ratio < least_ratio ? 1e9 / (ratio + 1e-9) : fill_of(i, j);
        if (cost < best_cost || (cost == best_cost && ratio > best_ratio)) {
          best = {i, j};
          best_cost = cost;
          best_ratio = ratio;
        }
      }
    }
    return best;
  }

  /// Markowitz's count for a pivot: multiplications of its step.
  double fill_of(int row, int column) const {
    int in_row = -1, in_column = -1;
    for (int k = 0; k < pattern_.rows(); ++k) {
      in_row += column_is_open_[k] && pattern_(row, k);
      in_column += row_is_open_[k] && pattern_(k, column);
    }
    return static_cast<double>(in_row) * in_column;
  }

  /// |pivot| over the largest open entry of its row, at the worst sample.
  double smallest_ratio(int row, int column) const {
    double smallest = 1;
    for (const Eigen::MatrixXcd& sample : samples_) {
      double largest = 0;
      for (int k = 0; k < sample.cols(); ++k)
        if (column_is_open_[k]) largest = std::max(largest, std::abs(sample(row, k)));
      smallest = std::min(smallest, largest > 0 ? std::abs(sample(row, column)) / largest : 0);
    }
    return smallest;
  }

  void eliminate(int i, int row, int column) {
    for (Eigen::MatrixXcd& sample : samples_) {
      const std::complex<double> factor = sample(i, column) / sample(row, column);
      for (int k = 0; k < sample.cols(); ++k)
        if (column_is_open_[k]) sample(i, k) -= factor * sample(row, k);
    }
    for (int k = 0; k < pattern_.cols(); ++k)
      if (column_is_open_[k] && pattern_(row, k)) pattern_(i, k) = true;
  }

  Pattern pattern_;
  std::vector<Eigen::MatrixXcd> samples_;
  std::vector<bool> row_is_open_;
  std::vector<bool> column_is_open_;
};

/// Number of each entry of the filled pattern, −1 elsewhere.
Eigen::MatrixXi numbered(const Pattern& pattern) {
  Eigen::MatrixXi entry = Eigen::MatrixXi::Constant(pattern.rows(), pattern.cols(), -1);
  int next = 0;
  for (int i = 0; i < pattern.rows(); ++i)
    for (int j = 0; j < pattern.cols(); ++j)
      if (pattern(i, j)) entry(i, j) = next++;
  return entry;
}

void append_steps(const Eigen::MatrixXi& entry, Elimination& elimination) {
  const auto& [rows, columns] = std::tie(elimination.equation, elimination.unknown);
  const int n = elimination.unknowns;
  for (int k = 0; k < n; ++k) {
    elimination.steps.push_back({entry(rows[k], columns[k]), static_cast<int>(elimination.lower.size()),
                                 static_cast<int>(elimination.upper.size())});
    std::vector<int> uppers;
    for (int j = k + 1; j < n; ++j) {
      if (entry(rows[k], columns[j]) < 0) continue;
      elimination.upper.push_back({j, entry(rows[k], columns[j])});
      uppers.push_back(j);
    }
    for (int i = k + 1; i < n; ++i) {
      if (entry(rows[i], columns[k]) < 0) continue;
      elimination.lower.push_back(
          {i, entry(rows[i], columns[k]), static_cast<int>(elimination.targets.size())});
      for (const int j : uppers) elimination.targets.push_back(entry(rows[i], columns[j]));
    }
  }
  elimination.steps.push_back(
      {-1, static_cast<int>(elimination.lower.size()), static_cast<int>(elimination.upper.size())});
}

void append_entries(const SquareSystem& system, const Eigen::MatrixXi& entry, Elimination& elimination) {
  const Pattern original = pattern_of(system);
  for (int e = 0; e < system.equations(); ++e) {
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [minuend, subtrahend, constant] = system.differences[d];
      elimination.entries_of.push_back({entry(e, minuend), subtrahend >= 0 ? entry(e, subtrahend) : -1});
    }
    for (int l = system.first_linear[e]; l < system.first_linear[e + 1]; ++l)
      elimination.entries_of_linear.push_back(entry(e, system.linear[l].unknown));
    for (int j = 0; j < system.unknowns; ++j)
      if (entry(e, j) >= 0 && !original(e, j)) elimination.fill.push_back(entry(e, j));
  }
}

}  // namespace

Elimination order_elimination(const SquareSystem& system, std::mt19937_64& random) {
  Elimination elimination;
  elimination.unknowns = system.unknowns;
  PivotSearch search(system, random);
  for (int k = 0; k < system.unknowns; ++k) {
    const auto [row, column] = search.next();
    elimination.equation.push_back(row);
    elimination.unknown.push_back(column);
  }
  const Eigen::MatrixXi entry = numbered(search.pattern());
  elimination.entries = entry.maxCoeff() + 1;
  append_steps(entry, elimination);
  append_entries(system, entry, elimination);
  return elimination;
}

}  // namespace gcs
