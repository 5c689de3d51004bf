#include "solvers/elements/element_forms.hpp"

#include <utility>

namespace gcs {
namespace {

/// Precondition: the number is not squared.
ExactNumber times_power_of_two(ExactNumber number, int exponent) {
  number.exponent += exponent;
  return number;
}

}  // namespace

LinearForm constant_form(const ExactNumber& number) { return {{}, number}; }

LinearForm negated(LinearForm form) {
  for (ScaledUnknown& term : form.terms) term.coefficient = negated(term.coefficient);
  form.constant = negated(form.constant);
  return form;
}

VectorForm negated(VectorForm forms) {
  for (LinearForm& form : forms) form = negated(std::move(form));
  return forms;
}

LinearForm difference(LinearForm left, const LinearForm& right) {
  const LinearForm opposite = negated(right);
  left.terms.insert(left.terms.end(), opposite.terms.begin(), opposite.terms.end());
  if (left.constant.is_zero()) left.constant = opposite.constant;
  return left;
}

VectorForm scaled(VectorForm forms, int exponent) {
  for (LinearForm& form : forms) {
    for (ScaledUnknown& term : form.terms) term.coefficient = times_power_of_two(term.coefficient, exponent);
    form.constant = times_power_of_two(form.constant, exponent);
  }
  return forms;
}

Equation& Equation::plus(const LinearForm& left, const LinearForm& right) {
  if (!is_zero(left) && !is_zero(right)) equation_.products.push_back({left, right});
  return *this;
}

Equation& Equation::plus(const VectorForm& left, const VectorForm& right) {
  for (std::size_t axis = 0; axis < 3; ++axis) plus(left[axis], right[axis]);
  return *this;
}

Equation& Equation::plus_square_of_difference(const VectorForm& left, const VectorForm& right) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!left[axis].constant.is_zero() && !right[axis].constant.is_zero()) {
      plus(left[axis], left[axis]).plus(right[axis], right[axis]);
      minus(scaled(left, 1)[axis], right[axis]);
      continue;
    }
    const LinearForm apart = difference(left[axis], right[axis]);
    plus(apart, apart);
  }
  return *this;
}

std::complex<double> value_at(const LinearForm& form, const std::vector<std::complex<double>>& x) {
  std::complex<double> sum = rounded_to_double(form.constant);
  for (const ScaledUnknown& term : form.terms)
    sum += rounded_to_double(term.coefficient) * x[static_cast<std::size_t>(term.unknown)];
  return sum;
}

}  // namespace gcs
