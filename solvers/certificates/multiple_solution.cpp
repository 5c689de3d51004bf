#include "solvers/certificates/multiple_solution.hpp"

#include <flint/fmpq_mat.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

using Vector = std::vector<Rational>;

/// The rows other than 0 of the reduced echelon form.
std::vector<Vector> echelon_form(const std::vector<Vector>& rows) {
  const std::size_t columns = rows.front().size();
  fmpq_mat_t matrix;
  fmpq_mat_init(matrix, static_cast<slong>(rows.size()), static_cast<slong>(columns));
  const auto entry = [&](std::size_t row, std::size_t column) {
    return fmpq_mat_entry(matrix, static_cast<slong>(row), static_cast<slong>(column));
  };
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < columns; ++column)
      fmpq_set(entry(row, column), rows[row][column].raw());
  std::vector<Vector> reduced(static_cast<std::size_t>(fmpq_mat_rref(matrix, matrix)), Vector(columns));
  for (std::size_t row = 0; row < reduced.size(); ++row)
    for (std::size_t column = 0; column < columns; ++column)
      reduced[row][column] = Rational::from_raw(entry(row, column));
  fmpq_mat_clear(matrix);
  return reduced;
}

/// The column of the first entry other than 0.
std::size_t pivot_of(const Vector& row) {
  return static_cast<std::size_t>(
      std::ranges::find_if(row, [](const Rational& entry) { return !entry.is_zero(); }) - row.begin());
}

struct Form {
  std::vector<std::pair<std::size_t, Rational>> terms;
  Rational constant;

  Rational linear(const Vector& x) const {
    Rational sum;
    for (const auto& [unknown, coefficient] : terms) sum = sum + coefficient * x[unknown];
    return sum;
  }
};

/// f(x) = Σ left(x)·right(x) − given, with exact coefficients.
struct Equation {
  std::vector<std::pair<Form, Form>> products;
  Rational given;
};

Form form_of(const LinearForm& exact) {
  Form form{{}, *fraction(exact.constant)};
  for (const ScaledUnknown& term : exact.terms)
    form.terms.emplace_back(term.unknown, *fraction(term.coefficient));
  return form;
}

/// Precondition: it has fractions.
Equation equation_of(const QuadraticEquation& exact) {
  Equation equation{{}, *fraction(exact.given)};
  for (const FormProduct& product : exact.products)
    equation.products.emplace_back(form_of(product.left), form_of(product.right));
  return equation;
}

/// The equations about a point x: f(x + w) = f(x) + Jw + B(w, w).
class AboutPoint {
 public:
  AboutPoint(std::vector<Equation> equations, const Vector& x) : equations_(std::move(equations)) {
    for (const Equation& equation : equations_) {
      Rational value = Rational(-1) * equation.given;
      Vector row(x.size());
      for (const auto& [left, right] : equation.products) {
        const Rational at_left = left.linear(x) + left.constant, at_right = right.linear(x) + right.constant;
        value = value + at_left * at_right;
        for (const auto& [unknown, coefficient] : left.terms)
          row[unknown] = row[unknown] + coefficient * at_right;
        for (const auto& [unknown, coefficient] : right.terms)
          row[unknown] = row[unknown] + coefficient * at_left;
      }
      is_zero_ = is_zero_ && value.is_zero();
      jacobian_.push_back(std::move(row));
    }
    if (is_zero_) reduced_ = echelon_form(jacobian_);
  }

  bool is_zero() const { return is_zero_; }
  /// What the Jacobian loses from its rank. Precondition: x is a zero.
  std::size_t corank() const { return jacobian_.size() - reduced_.size(); }

  /// f vanishes to this order along a curve through the point, `most` at most. Precondition: corank 1.
  int order_of_contact(int most) const {
    std::vector<Vector> curve{Vector(jacobian_.size()), kernel()};
    for (int order = 2; order < most; ++order) {
      std::optional<Vector> next = solution(square(curve, order));
      if (!next) return order;
      curve.push_back(*std::move(next));
    }
    return most;
  }

 private:
  /// A vector other than 0 that J takes to 0. Precondition: corank 1.
  Vector kernel() const {
    std::size_t free = 0;
    while (free < reduced_.size() && pivot_of(reduced_[free]) == free) ++free;
    Vector result(jacobian_.size());
    result[free] = 1;
    for (const Vector& row : reduced_) result[pivot_of(row)] = Rational(-1) * row[free];
    return result;
  }

  /// w with Jw + right = 0.
  std::optional<Vector> solution(const Vector& right) const {
    std::vector<Vector> rows = jacobian_;
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].push_back(Rational(-1) * right[i]);
    Vector result(rows.size());
    for (const Vector& row : echelon_form(rows)) {
      const std::size_t pivot = pivot_of(row);
      if (pivot == result.size()) return std::nullopt;
      result[pivot] = row.back();
    }
    return result;
  }

  /// What the curve's terms below `order` make of b^order in B(w, w).
  Vector square(const std::vector<Vector>& curve, int order) const {
    Vector result;
    for (const Equation& equation : equations_) {
      Rational sum;
      for (std::size_t i = 1; i < static_cast<std::size_t>(order); ++i)
        for (const auto& [left, right] : equation.products)
          sum = sum + left.linear(curve[i]) * right.linear(curve[static_cast<std::size_t>(order) - i]);
      result.push_back(sum);
    }
    return result;
  }

  std::vector<Equation> equations_;
  std::vector<Vector> jacobian_, reduced_;  ///< and its echelon form, at a zero
  bool is_zero_ = true;
};

}  // namespace

std::optional<std::vector<Rational>> simplest_fractions(const std::vector<std::complex<double>>& x,
                                                        const std::vector<double>& radius) {
  std::vector<Rational> fractions;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!(std::abs(x[i].imag()) <= radius[i])) return std::nullopt;
    const Rational middle = Rational::from_double(x[i].real()), reach = Rational::from_double(radius[i]);
    fmpq_t simplest;
    fmpq_init(simplest);
    fmpq_simplest_between(simplest, (middle - reach).raw(), (middle + reach).raw());
    fractions.push_back(Rational::from_raw(simplest));
    fmpq_clear(simplest);
  }
  return fractions;
}

BallMatrix enclosed(const std::vector<Rational>& x, slong bits) {
  BallMatrix result(static_cast<slong>(x.size()), 1);
  for (std::size_t i = 0; i < x.size(); ++i) acb_set_fmpq(result(static_cast<slong>(i), 0), x[i].raw(), bits);
  return result;
}

int least_multiplicity(const QuadraticSystem& system, const std::vector<Rational>& x, int most) {
  if (!std::ranges::all_of(system.equations, has_fractions)) return 0;
  std::vector<Equation> equations;
  for (const QuadraticEquation& exact : system.equations) equations.push_back(equation_of(exact));
  const AboutPoint point(std::move(equations), x);
  if (!point.is_zero()) return 0;
  const std::size_t corank = point.corank();
  if (corank == 1) return point.order_of_contact(most);
  return static_cast<int>(std::min(std::ldexp(1, static_cast<int>(corank)), static_cast<double>(most)));
}

}  // namespace gcs
