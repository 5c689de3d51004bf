#include "solvers/polyhedral/eliminated_equations.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "solvers/polyhedral/polyhedral_homotopies.hpp"

namespace gcs {
namespace {

/// Of what a coefficient was computed from: less is rounding.
constexpr double cancelled = 1e-12;

/// Columns in order: the highest degree first.
struct HigherFirst {
  static int degree(const Exponents& exponents) {
    int sum = 0;
    for (const int exponent : exponents) sum += exponent;
    return sum;
  }
  bool operator()(const Exponents& a, const Exponents& b) const {
    return degree(a) != degree(b) ? degree(a) > degree(b) : a > b;
  }
};

/// Equations as rows over their monomials.
class MonomialElimination {
 public:
  MonomialElimination(const MonomialSystem& system, const ComplexVectorX& coefficients) {
    const Supports supports = supports_of(system);
    for (const Support& support : supports)
      for (const Exponents& monomial : support) columns_.emplace(monomial, 0);
    Eigen::Index next = 0;
    for (auto& [monomial, column] : columns_) column = next++;
    rows_ = Eigen::MatrixXcd::Zero(system.equations(), next);
    auto coefficient = coefficients.begin();
    for (std::size_t e = 0; e < supports.size(); ++e)
      for (const Exponents& monomial : supports[e])
        rows_(static_cast<Eigen::Index>(e), columns_.at(monomial)) = *coefficient++;
    sizes_ = rows_.cwiseAbs();
  }

  EliminatedEquations run() {
    Eigen::Index done = 0;
    for (Eigen::Index column = 0; column < rows_.cols() && done < rows_.rows(); ++column)
      if (bring_up_pivot(done, column)) eliminate(done++, column);
    EliminatedEquations result;
    for (Eigen::Index row = 0; row < rows_.rows(); ++row) {
      result.supports.emplace_back();
      for (const auto& [monomial, column] : columns_) {
        if (rows_(row, column) == 0.0) continue;
        result.supports.back().push_back(monomial);
        result.coefficients.push_back(rows_(row, column));
      }
    }
    return result;
  }

 private:
  /// The row with the largest entry of the column, its own relative to its largest; false where all are 0.
  bool bring_up_pivot(Eigen::Index first, Eigen::Index column) {
    Eigen::Index best = -1;
    double largest = 0;
    for (Eigen::Index row = first; row < rows_.rows(); ++row) {
      const double entry = std::abs(rows_(row, column)) / rows_.row(row).cwiseAbs().maxCoeff();
      if (!(entry > largest)) continue;
      largest = entry;
      best = row;
    }
    if (best < 0) return false;
    rows_.row(first).swap(rows_.row(best));
    sizes_.row(first).swap(sizes_.row(best));
    return true;
  }

  /// From all rows but that of the pivot, which is made 1.
  void eliminate(Eigen::Index pivot, Eigen::Index column) {
    const std::complex<double> one = rows_(pivot, column);
    rows_.row(pivot) /= one;
    sizes_.row(pivot) /= std::abs(one);
    for (Eigen::Index row = 0; row < rows_.rows(); ++row) {
      const std::complex<double> factor = rows_(row, column);
      if (row == pivot || factor == 0.0) continue;
      rows_.row(row) -= factor * rows_.row(pivot);
      sizes_.row(row) += std::abs(factor) * sizes_.row(pivot);
      for (Eigen::Index i = 0; i < rows_.cols(); ++i)
        if (i == column || std::abs(rows_(row, i)) <= cancelled * sizes_(row, i)) rows_(row, i) = 0;
    }
  }

  std::map<Exponents, Eigen::Index, HigherFirst> columns_;
  Eigen::MatrixXcd rows_;
  Eigen::MatrixXd sizes_;  ///< of what entries were computed from
};

}  // namespace

EliminatedEquations eliminated_equations(const MonomialSystem& system, const ComplexVectorX& coefficients) {
  return MonomialElimination(system, coefficients).run();
}

EliminatedEquations with_constant_terms(EliminatedEquations equations) {
  EliminatedEquations result;
  auto coefficient = equations.coefficients.begin();
  for (Support& support : equations.supports) {
    const Exponents constant(support.front().size(), 0);
    const auto end = coefficient + std::ssize(support);
    result.coefficients.insert(result.coefficients.end(), coefficient, end);
    coefficient = end;
    if (std::ranges::find(support, constant) == support.end()) {
      support.push_back(constant);
      result.coefficients.emplace_back(0);
    }
    result.supports.push_back(std::move(support));
  }
  return result;
}

}  // namespace gcs
