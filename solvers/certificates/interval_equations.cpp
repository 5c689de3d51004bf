#include "solvers/certificates/interval_equations.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "solvers/model/given_numbers.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// Of double-doubles: products and sums of a hundred terms are right to this, relative to the terms.
constexpr double fine_rounding = 0x1p-92;
/// And so are those of doubles.
constexpr double coarse_rounding = 0x1p-44;

EnclosedNumber enclosed(const ExactNumber& number) {
  const DoubleDouble value = nearest_double_double(number);
  const bool is_double = number.decimal.empty() && !number.is_squared && value.lo == 0;
  return {value, is_double ? exact_interval(value.hi) : enclosing(value)};
}

bool same(const ExactNumber& a, const ExactNumber& b) {
  return a.decimal == b.decimal && a.value == b.value && a.exponent == b.exponent &&
         a.is_squared == b.is_squared && a.is_negative == b.is_negative &&
         a.is_cosine_of_degrees == b.is_cosine_of_degrees && a.divided_by_norm_of.empty() &&
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

DoubleDouble imaginary_part(const ExactNumber& number) {
  if (number.value.imag() == 0) return {};
  ExactNumber turned = number;
  turned.value = {number.value.imag(), 0};
  return nearest_double_double(turned);
}

double size_of(double number) { return std::abs(number); }
double size_of(const std::complex<double>& number) {
  return std::abs(number.real()) + std::abs(number.imag());
}

DoubleDouble given_of(const IntervalEquation& equation, double) { return equation.given.value; }
ComplexDoubleDouble given_of(const IntervalEquation& equation, const std::complex<double>&) {
  return {equation.given.value, equation.imaginary_given};
}

/// A form at a point, and the sum of its terms' sizes.
template <typename Wide>
struct WideForm {
  Wide value;
  double size = 0;
};

template <typename Scalar>
auto value_at(const IntervalForm& form, const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x) {
  WideForm<decltype(widened(Scalar()))> result{widened(Scalar()), std::abs(form.constant.value.hi)};
  result.value = result.value - -form.constant.value;
  for (const auto& [unknown, coefficient] : form.terms) {
    result.value = result.value + coefficient.value * widened(x[unknown]);
    result.size += size_of(coefficient.value.hi * x[unknown]);
  }
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
    equations.push_back({{}, enclosed(equation.given), imaginary_part(equation.given)});
    for (const auto& [left, right] : equation.products) {
      equations.back().products.push_back({number_of(left), number_of(right)});
      if (left.terms.empty() || right.terms.empty()) continue;
      for (const LinearForm* form : {&left, &right})
        for (const ScaledUnknown& term : form->terms)
          is_nonlinear[static_cast<std::size_t>(term.unknown)] = true;
    }
  }
}

template <typename Scalar>
LinearisedSystem<Scalar> linearised(const IntervalEquations& system,
                                    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x) {
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using Form = decltype(value_at(system.forms.front(), x));
  const Eigen::Index n = x.size();
  LinearisedSystem<Scalar> f{Vector(n), Eigen::VectorXd(n), Matrix::Zero(n, n)};
  std::vector<Form> values;
  for (const IntervalForm& form : system.forms) values.push_back(value_at(form, x));
  for (Eigen::Index e = 0; e < n; ++e) {
    const IntervalEquation& equation = system.equations[static_cast<std::size_t>(e)];
    const auto given = given_of(equation, Scalar());
    auto sum = widened(Scalar()) - given;
    double size = size_of(given.value());
    for (const auto& [l, r] : equation.products) {
      const Form &left = values[static_cast<std::size_t>(l)], &right = values[static_cast<std::size_t>(r)];
      sum = sum + left.value * right.value;
      size += left.size * right.size;
      for (const auto& [unknown, coefficient] : system.forms[static_cast<std::size_t>(l)].terms)
        f.jacobian(e, unknown) += coefficient.value.hi * right.value.value();
      for (const auto& [unknown, coefficient] : system.forms[static_cast<std::size_t>(r)].terms)
        f.jacobian(e, unknown) += coefficient.value.hi * left.value.value();
    }
    f.value[e] = sum.value();
    f.value_error[e] = epsilon * std::abs(f.value[e]) + fine_rounding * size + underflow;
  }
  return f;
}

template <typename Scalar>
Eigen::MatrixXd jacobian_radius(const IntervalEquations& system,
                                const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x,
                                const Eigen::VectorXd& radius) {
  std::vector<double> moves;
  for (const IntervalForm& form : system.forms) {
    double move = 0, size = std::abs(form.constant.value.hi);
    for (const auto& [unknown, coefficient] : form.terms) {
      const double c = std::abs(coefficient.value.hi);
      move += c * radius[unknown];
      size += c * size_of(x[unknown]);
    }
    moves.push_back(move * (1 + coarse_rounding) + coarse_rounding * size + underflow);
  }
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(radius.size(), radius.size());
  const auto add = [&](Eigen::Index e, int form, int other) {
    for (const auto& [unknown, coefficient] : system.forms[static_cast<std::size_t>(form)].terms)
      result(e, unknown) +=
          std::abs(coefficient.value.hi) * moves[static_cast<std::size_t>(other)] * (1 + coarse_rounding);
  };
  for (Eigen::Index e = 0; e < radius.size(); ++e)
    for (const auto& [left, right] : system.equations[static_cast<std::size_t>(e)].products) {
      add(e, left, right);
      add(e, right, left);
    }
  return result * (1 + coarse_rounding);
}

template LinearisedSystem<double> linearised(const IntervalEquations&, const Eigen::VectorXd&);
template LinearisedSystem<std::complex<double>> linearised(const IntervalEquations&, const Eigen::VectorXcd&);
template Eigen::MatrixXd jacobian_radius(const IntervalEquations&, const Eigen::VectorXd&,
                                         const Eigen::VectorXd&);
template Eigen::MatrixXd jacobian_radius(const IntervalEquations&, const Eigen::VectorXcd&,
                                         const Eigen::VectorXd&);

}  // namespace gcs
