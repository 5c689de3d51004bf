#pragma once
/// Quadratic equations with enclosed coefficients on affine forms.

#include <cstddef>
#include <utility>
#include <vector>

#include "solvers/certificates/interval_equations.hpp"
#include "solvers/scanning/piece.hpp"

namespace gcs {

template <int N>
class FormsOfEquations {
 public:
  using Form = AffineForm<N>;

  explicit FormsOfEquations(const IntervalEquations& system) : system_(&system) {
    for (const IntervalForm& form : system.forms) {
      constants_.push_back(enclosed(form.constant));
      coefficients_.emplace_back();
      for (const IntervalForm::Term& term : form.terms)
        coefficients_.back().push_back(enclosed(term.coefficient));
    }
    for (const IntervalEquation& equation : system.equations) given_.push_back(enclosed(equation.given));
  }

  /// Left-hand side less right-hand side. `x`: a form of each unknown by its number.
  template <class Unknowns>
  Form excess(int equation, const Unknowns& x) const {
    const auto e = static_cast<std::size_t>(equation);
    Form sum = -given_[e];
    for (const IntervalProduct& product : system_->equations[e].products) {
      const Form left = value(product.left, x);
      sum = sum + (product.is_square() ? square(left) : left * value(product.right, x));
    }
    return sum;
  }

  /// excess = rate·x[unknown] + rest. Precondition: the equation is linear in it.
  struct Line {
    Form rate, rest;
  };
  template <class Unknowns>
  Line line(int equation, int unknown, const Unknowns& x) const {
    const auto e = static_cast<std::size_t>(equation);
    Line line{Form(), -given_[e]};
    for (auto [with, without] : system_->equations[e].products) {
      const Form* coefficient = coefficient_of(with, unknown);
      if (coefficient == nullptr) {
        std::swap(with, without);
        coefficient = coefficient_of(with, unknown);
      }
      const Form factor = value(without, x);
      line.rest = line.rest + value(with, x, unknown) * factor;
      if (coefficient != nullptr) line.rate = line.rate + *coefficient * factor;
    }
    return line;
  }

 private:
  static Form enclosed(const EnclosedNumber& number) {
    const bool is_double = number.interval.low == number.interval.high;
    return is_double ? Form(number.value.hi) : enclosing_form<N>(number.value);
  }

  const Form* coefficient_of(int form, int unknown) const {
    const auto f = static_cast<std::size_t>(form);
    for (std::size_t i = 0; i < coefficients_[f].size(); ++i)
      if (system_->forms[f].terms[i].unknown == unknown) return &coefficients_[f][i];
    return nullptr;
  }

  /// Without the term of one unknown.
  template <class Unknowns>
  Form value(int form, const Unknowns& x, int left_out = -1) const {
    const auto f = static_cast<std::size_t>(form);
    Form sum = constants_[f];
    for (std::size_t i = 0; i < coefficients_[f].size(); ++i) {
      const int unknown = system_->forms[f].terms[i].unknown;
      if (unknown != left_out) sum = sum + coefficients_[f][i] * x(unknown);
    }
    return sum;
  }

  const IntervalEquations* system_;
  std::vector<Form> constants_, given_;
  std::vector<std::vector<Form>> coefficients_;  // by form and term
};

}  // namespace gcs
