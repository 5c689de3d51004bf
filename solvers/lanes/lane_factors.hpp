#pragma once
/// Sparse Jacobians in lanes, factorised as J = L D U with unit diagonals of L and U in the order of
/// elimination.hpp, and solutions with the factors: of these there are many for one factorisation, so that
/// what they need lies in the order in which they need it, and no division is left to them.

#include <vector>

#include "solvers/lanes/complex_lanes.hpp"
#include "solvers/lanes/elimination.hpp"

namespace gcs::GCS_LANES {

template <class Number>
class LaneFactors {
 public:
  /// The elimination is referred to, not copied.
  explicit LaneFactors(const Elimination& elimination)
      : elimination_(elimination),
        entries_(elimination.entries),
        inverse_pivots_(elimination.unknowns),
        lower_(lower_rows(elimination)),
        upper_(upper_rows(elimination)) {}

  /// The entries of the Jacobian, as elimination.hpp numbers them and all 0, for `factorise`.
  std::vector<Number>& cleared_entries() {
    for (Number& entry : entries_) entry = {};
    return entries_;
  }

  /// Of the entries that were filled in; a pivot that is 0 leaves factors that are no numbers.
  void factorise() {
    for (std::size_t k = 0; k < inverse_pivots_.size(); ++k) eliminate(k);
    for (std::size_t t = 0; t < lower_.terms.size(); ++t) lower_.factors[t] = entries_[lower_.terms[t].entry];
    for (const Row& row : upper_.rows)
      for (int t = row.first; t < row.last; ++t)
        upper_.factors[t] = product(entries_[upper_.terms[t].entry], inverse_pivots_[row.unknown]);
  }

  /// J z = right, in the order of elimination: right[k] belongs to the k-th equation, z[k] to the k-th
  /// unknown. In place.
  void solve(std::vector<Number>& right) const {
    substitute(lower_, right);
    for (std::size_t k = 0; k < right.size(); ++k) right[k] = product(right[k], inverse_pivots_[k]);
    substitute(upper_, right);
  }

 private:
  /// An entry off the diagonal of a factor: factor·z[unknown].
  struct Term {
    int unknown = 0;
    int entry = 0;  ///< of the Jacobian, in whose place it comes about
  };
  struct Row {
    int unknown = 0;          ///< with the 1 on the diagonal
    int first = 0, last = 0;  ///< its terms are first … last − 1
  };
  /// Rows in an order in which each needs but earlier ones.
  struct Triangle {
    std::vector<Row> rows;
    std::vector<Term> terms;
    std::vector<Number> factors;  ///< of the terms, without gaps: all are read for each solution
  };

  static Triangle lower_rows(const Elimination& elimination) {
    std::vector<std::vector<Term>> terms(elimination.unknowns);
    for (int k = 0; k < elimination.unknowns; ++k)
      for (int l = elimination.steps[k].first_lower; l < elimination.steps[k + 1].first_lower; ++l)
        terms[elimination.lower[l].row].push_back({k, elimination.lower[l].entry});
    Triangle lower;
    for (int k = 0; k < elimination.unknowns; ++k) append_row(k, terms[k], lower);
    return lower;
  }

  static Triangle upper_rows(const Elimination& elimination) {
    Triangle upper;
    for (int k = elimination.unknowns - 1; k >= 0; --k) {
      std::vector<Term> terms;
      // The unknown that is known last comes last: what does not wait for it is done by then.
      for (int u = elimination.steps[k + 1].first_upper - 1; u >= elimination.steps[k].first_upper; --u)
        terms.push_back({elimination.upper[u].column, elimination.upper[u].entry});
      append_row(k, terms, upper);
    }
    return upper;
  }

  static void append_row(int unknown, const std::vector<Term>& terms, Triangle& triangle) {
    const auto first = static_cast<int>(triangle.terms.size());
    triangle.terms.insert(triangle.terms.end(), terms.begin(), terms.end());
    triangle.factors.resize(triangle.terms.size());
    triangle.rows.push_back({unknown, first, static_cast<int>(triangle.terms.size())});
  }

  static void substitute(const Triangle& triangle, std::vector<Number>& z) {
    for (const Row& row : triangle.rows) {
      Number sum = z[row.unknown];
      for (int t = row.first; t < row.last; ++t)
        sum = fused_minus(triangle.factors[t], z[triangle.terms[t].unknown], sum);
      z[row.unknown] = sum;
    }
  }

  void eliminate(std::size_t k) {
    const Elimination::Step &step = elimination_.steps[k], &next = elimination_.steps[k + 1];
    inverse_pivots_[k] = inverse(entries_[step.pivot]);
    for (int l = step.first_lower; l < next.first_lower; ++l) {
      const auto& [row, entry, targets] = elimination_.lower[l];
      const Number factor = product(entries_[entry], inverse_pivots_[k]);
      entries_[entry] = factor;
      const int* target = elimination_.targets.data() + targets;
      for (int u = step.first_upper; u < next.first_upper; ++u, ++target)
        entries_[*target] = fused_minus(factor, entries_[elimination_.upper[u].entry], entries_[*target]);
    }
  }

  const Elimination& elimination_;
  std::vector<Number> entries_;  ///< the Jacobian, then L below the diagonal and D U on and above it
  std::vector<Number> inverse_pivots_;
  Triangle lower_;
  Triangle upper_;
};

}  // namespace gcs::GCS_LANES
