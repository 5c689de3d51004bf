#include "solvers/subdivision/interval_equations.hpp"

#include <algorithm>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

EnclosedNumber enclosed(const ExactNumber& number) {
  const DoubleDouble value = nearest_double_double(number);
  const bool is_double = number.decimal.empty() && !number.is_squared && value.lo == 0;
  return {value, is_double ? exact_interval(value.hi) : enclosing(value)};
}

bool same(const ExactNumber& a, const ExactNumber& b) {
  return a.decimal == b.decimal && a.value == b.value && a.exponent == b.exponent &&
         a.is_squared == b.is_squared && a.is_negative == b.is_negative && a.divided_by_norm_of.empty() &&
         b.divided_by_norm_of.empty();
}

bool same(const LinearForm& a, const LinearForm& b) {
  return same(a.constant, b.constant) &&
         std::equal(a.terms.begin(), a.terms.end(), b.terms.begin(), b.terms.end(),
                    [](const ScaledUnknown& s, const ScaledUnknown& t) {
                      return s.unknown == t.unknown && same(s.coefficient, t.coefficient);
                    });
}

IntervalForm enclosed(const LinearForm& form) {
  IntervalForm result{{}, enclosed(form.constant)};
  for (const ScaledUnknown& term : form.terms)
    result.terms.push_back({term.unknown, enclosed(term.coefficient)});
  return result;
}

}  // namespace

Interval IntervalForm::over(const IntervalBox& box) const {
  Interval sum = constant.interval;
  for (const Term& term : terms)
    sum = sum + term.coefficient.interval * box[static_cast<std::size_t>(term.unknown)];
  return sum;
}

IntervalEquations::IntervalEquations(const QuadraticSystem& system)
    : unknowns(system.unknowns), is_nonlinear(static_cast<std::size_t>(system.unknowns), false) {
  std::vector<const LinearForm*> known;
  const auto number_of = [&](const LinearForm& form) {
    const auto found =
        std::find_if(known.begin(), known.end(), [&](const LinearForm* other) { return same(form, *other); });
    if (found != known.end()) return static_cast<int>(found - known.begin());
    known.push_back(&form);
    forms.push_back(enclosed(form));
    return static_cast<int>(known.size()) - 1;
  };
  for (const QuadraticEquation& equation : system.equations) {
    equations.push_back({{}, enclosed(equation.given)});
    for (const auto& [left, right] : equation.products) {
      equations.back().products.push_back({number_of(left), number_of(right)});
      if (left.terms.empty() || right.terms.empty()) continue;
      for (const LinearForm* form : {&left, &right})
        for (const ScaledUnknown& term : form->terms)
          is_nonlinear[static_cast<std::size_t>(term.unknown)] = true;
    }
  }
}

}  // namespace gcs
