#include "solvers/lanes/elimination.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace gcs {
namespace {

using Pattern = Eigen::Matrix<bool, Eigen::Dynamic, Eigen::Dynamic>;

std::vector<Eigen::MatrixXcd> matrices(int n, const std::vector<ComplexVectorX>& jacobians) {
  std::vector<Eigen::MatrixXcd> result;
  for (const ComplexVectorX& jacobian : jacobians) {
    Eigen::MatrixXcd& matrix = result.emplace_back(n, n);
    for (int e = 0; e < n; ++e)
      for (int i = 0; i < n; ++i) matrix(e, i) = jacobian[e * n + i];
  }
  return result;
}

Pattern pattern_of(const std::vector<Eigen::MatrixXcd>& samples) {
  Pattern pattern = Pattern::Constant(samples.front().rows(), samples.front().cols(), false);
  for (const Eigen::MatrixXcd& sample : samples) pattern = pattern || (sample.array() != 0.0).matrix();
  return pattern;
}

/// Eliminates the same pattern at several placements at once and picks the pivots.
class PivotSearch {
 public:
  PivotSearch(Pattern pattern, std::vector<Eigen::MatrixXcd> samples)
      : pattern_(std::move(pattern)),
        samples_(std::move(samples)),
        row_is_open_(static_cast<std::size_t>(pattern_.rows()), true),
        column_is_open_(static_cast<std::size_t>(pattern_.cols()), true) {
    for (int k = 0; k < pattern_.rows(); ++k) {
      in_row_.push_back(static_cast<int>(pattern_.row(k).count()));
      in_column_.push_back(static_cast<int>(pattern_.col(k).count()));
      ratios_.push_back(smallest_ratios(k));
    }
  }

  /// Row and column of the next pivot, which is then eliminated.
  std::array<int, 2> next() {
    const auto [row, column] = choose();
    row_is_open_[row] = column_is_open_[column] = false;
    for (int k = 0; k < pattern_.rows(); ++k) {
      in_column_[k] -= pattern_(row, k);
      in_row_[k] -= pattern_(k, column);
    }
    for (int i = 0; i < pattern_.rows(); ++i)
      if (row_is_open_[i] && pattern_(i, column)) {
        eliminate(i, row, column);
        ratios_[i] = smallest_ratios(i);
      }
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
        const double ratio = ratios_[i][j];
        // At a singular sample there may be none.
        const double cost = ratio >= least_ratio ? fill_of(i, j) : 1e9 / (std::max(0.0, ratio) + 1e-9);
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
    return static_cast<double>(in_row_[row] - 1) * (in_column_[column] - 1);
  }

  /// Of each open column |pivot| over the largest open entry of the row, at the worst sample.
  Eigen::ArrayXd smallest_ratios(int row) const {
    Eigen::ArrayXd smallest = Eigen::ArrayXd::Ones(pattern_.cols());
    for (const Eigen::MatrixXcd& sample : samples_) {
      Eigen::ArrayXd sizes = Eigen::ArrayXd::Zero(pattern_.cols());
      for (int k = 0; k < pattern_.cols(); ++k)
        if (column_is_open_[k]) sizes[k] = std::abs(sample(row, k));
      const double largest = sizes.maxCoeff();
      smallest = smallest.min(largest > 0 ? Eigen::ArrayXd(sizes / largest) : sizes);
    }
    return smallest;
  }

  void eliminate(int i, int row, int column) {
    for (Eigen::MatrixXcd& sample : samples_) {
      const std::complex<double> factor = sample(i, column) / sample(row, column);
      for (int k = 0; k < sample.cols(); ++k)
        if (column_is_open_[k]) sample(i, k) -= factor * sample(row, k);
    }
    for (int k = 0; k < pattern_.cols(); ++k) {
      if (!column_is_open_[k] || !pattern_(row, k) || pattern_(i, k)) continue;
      pattern_(i, k) = true;
      ++in_row_[i];
      ++in_column_[k];
    }
  }

  Pattern pattern_;
  std::vector<Eigen::MatrixXcd> samples_;
  std::vector<bool> row_is_open_;
  std::vector<bool> column_is_open_;
  std::vector<Eigen::ArrayXd> ratios_;   ///< of all rows
  std::vector<int> in_row_, in_column_;  ///< entries in open columns of a row, in open rows of a column
};

/// Number of each entry of the filled pattern, −1 elsewhere.
std::vector<int> numbered(const Pattern& pattern, int& count) {
  std::vector<int> numbers;
  count = 0;
  for (int i = 0; i < pattern.rows(); ++i)
    for (int j = 0; j < pattern.cols(); ++j) numbers.push_back(pattern(i, j) ? count++ : -1);
  return numbers;
}

void append_steps(Elimination& elimination) {
  const auto& [rows, columns] = std::tie(elimination.equation, elimination.unknown);
  const int n = elimination.unknowns;
  for (int k = 0; k < n; ++k) {
    elimination.steps.push_back({elimination.entry(rows[k], columns[k]),
                                 static_cast<int>(elimination.lower.size()),
                                 static_cast<int>(elimination.upper.size())});
    std::vector<int> uppers;
    for (int j = k + 1; j < n; ++j) {
      const int entry = elimination.entry(rows[k], columns[j]);
      if (entry < 0) continue;
      elimination.upper.push_back({j, entry});
      uppers.push_back(j);
    }
    for (int i = k + 1; i < n; ++i) {
      const int entry = elimination.entry(rows[i], columns[k]);
      if (entry < 0) continue;
      elimination.lower.push_back({i, entry, static_cast<int>(elimination.targets.size())});
      for (const int j : uppers) elimination.targets.push_back(elimination.entry(rows[i], columns[j]));
    }
  }
  elimination.steps.push_back(
      {-1, static_cast<int>(elimination.lower.size()), static_cast<int>(elimination.upper.size())});
}

Elimination ordered(Pattern pattern, std::vector<Eigen::MatrixXcd> samples) {
  Elimination elimination;
  elimination.unknowns = static_cast<int>(pattern.cols());
  PivotSearch search(std::move(pattern), std::move(samples));
  for (int k = 0; k < elimination.unknowns; ++k) {
    const auto [row, column] = search.next();
    elimination.equation.push_back(row);
    elimination.unknown.push_back(column);
  }
  elimination.entry_numbers = numbered(search.pattern(), elimination.entries);
  append_steps(elimination);
  return elimination;
}

std::vector<Eigen::MatrixXcd> at_random_points(const SquareSystem& system, std::mt19937_64& random) {
  constexpr int samples = 6;
  std::vector<ComplexVectorX> jacobians;
  for (int i = 0; i < samples; ++i)
    jacobians.push_back(jacobian_at(system, random_complex_vector(system.unknowns, random)));
  return matrices(system.unknowns, jacobians);
}

}  // namespace

Elimination::Elimination() = default;
Elimination::Elimination(const Elimination&) = default;
Elimination::Elimination(Elimination&&) noexcept = default;
Elimination& Elimination::operator=(const Elimination&) = default;
Elimination& Elimination::operator=(Elimination&&) noexcept = default;
Elimination::~Elimination() = default;

Elimination order_elimination(const MonomialSystem& system, const std::vector<ComplexVectorX>& jacobians) {
  std::vector<Eigen::MatrixXcd> samples = matrices(system.unknowns, jacobians);
  Pattern pattern = pattern_of(samples);
  for (int e = 0; e < system.equations(); ++e)
    for (int j = system.first[e]; j < system.first[e + 1]; ++j)
      for (const int i : {system.monomials[j].u, system.monomials[j].v})
        if (i >= 0) pattern(e, i) = true;
  return ordered(std::move(pattern), std::move(samples));
}

Elimination order_elimination(const SquareSystem& system, std::mt19937_64& random) {
  std::vector<Eigen::MatrixXcd> samples = at_random_points(system, random);
  Pattern pattern = pattern_of(samples);
  return ordered(std::move(pattern), std::move(samples));
}

Elimination order_elimination(int n, const double* pattern, const double* sample) {
  const Eigen::Map<const Eigen::MatrixXd> entries(pattern, n, n), matrix(sample, n, n);
  return ordered((entries.array() != 0).matrix(), {matrix.cast<std::complex<double>>()});
}

Elimination order_elimination_at(const SquareSystem& system, const ComplexVectorX&, const ComplexVectorX& x) {
  std::mt19937_64 random(1);  // any points show where there are entries
  return ordered(pattern_of(at_random_points(system, random)),
                 matrices(system.unknowns, {jacobian_at(system, x)}));
}

Elimination order_elimination_at(const MonomialSystem& system, const ComplexVectorX& parameters,
                                 const ComplexVectorX& x) {
  return order_elimination(system, {jacobian_at(system, parameters, x)});
}

}  // namespace gcs
