#include "solvers/certificates/squared_differences.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "solvers/numeric/balls.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// 1, −1, or 0 for any other number.
int sign_of(const ExactNumber& number) {
  if (!number.decimal.empty() || number.exponent != 0 || std::abs(number.value) != 1.0) return 0;
  return (number.value == 1.0) == (number.is_negative && !number.is_squared) ? -1 : 1;
}

bool is_same(const LinearForm& a, const LinearForm& b) {
  const auto same = [](const ScaledUnknown& s, const ScaledUnknown& t) {
    return s.unknown == t.unknown && sign_of(s.coefficient) == sign_of(t.coefficient);
  };
  return b.constant.is_zero() &&
         std::equal(a.terms.begin(), a.terms.end(), b.terms.begin(), b.terms.end(), same);
}

/// The unknowns of ±x_i or ±(x_i − x_j), −1 for one that is not there; nothing for another form.
std::optional<std::array<int, 2>> difference_of(const LinearForm& form) {
  if (!form.constant.is_zero() || form.terms.empty() || form.terms.size() > 2) return std::nullopt;
  const int sign = sign_of(form.terms[0].coefficient);
  if (sign == 0) return std::nullopt;
  if (form.terms.size() == 1) return std::array{form.terms[0].unknown, -1};
  if (sign_of(form.terms[1].coefficient) != -sign) return std::nullopt;
  return std::array{form.terms[0].unknown, form.terms[1].unknown};
}

DoubleDouble rounded(arb_srcptr number) {
  constexpr slong bits = 200;
  arb_t rest;
  arb_init(rest);
  const double hi = arf_get_d(arb_midref(number), ARF_RND_NEAR);
  arb_set_d(rest, hi);
  arb_sub(rest, number, rest, bits);
  const double lo = arf_get_d(arb_midref(rest), ARF_RND_NEAR);
  arb_clear(rest);
  return {hi, lo};
}

ComplexDoubleDouble rounded(const ExactNumber& number) {
  Ball ball;
  enclose(ball, number, 200);
  return {rounded(acb_realref(static_cast<acb_srcptr>(ball))),
          rounded(acb_imagref(static_cast<acb_srcptr>(ball)))};
}

DoubleDouble given_as(const ComplexDoubleDouble& number, double) { return number.re; }
ComplexDoubleDouble given_as(const ComplexDoubleDouble& number, std::complex<double>) { return number; }

double size_of(const ComplexDoubleDouble& number) { return std::abs(number.re.hi) + std::abs(number.im.hi); }

}  // namespace

std::optional<SquaredDifferences> SquaredDifferences::of(const QuadraticSystem& system) {
  SquaredDifferences result;
  result.curvature = Eigen::MatrixXd::Zero(system.unknowns, system.unknowns);
  for (const QuadraticEquation& equation : system.equations) {
    Equation own;
    own.given = rounded(equation.given);
    for (const FormProduct& product : equation.products) {
      const auto pair = difference_of(product.left);
      if (!pair || !is_same(product.left, product.right)) return std::nullopt;
      own.pairs.push_back(*pair);
      for (const int unknown : *pair)
        if (unknown >= 0)
          result.curvature(static_cast<Eigen::Index>(result.equations.size()), unknown) =
              (*pair)[1] >= 0 ? 4 : 2;
    }
    result.equations.push_back(std::move(own));
  }
  return result;
}

template <typename Scalar>
LinearisedSystem<Scalar> linearised(const SquaredDifferences& system,
                                    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x) {
  using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  const Eigen::Index m = x.size();
  LinearisedSystem<Scalar> f{Vector(m), Eigen::VectorXd(m), Matrix::Zero(m, m)};
  for (Eigen::Index e = 0; e < m; ++e) {
    const SquaredDifferences::Equation& equation = system.equations[static_cast<std::size_t>(e)];
    auto sum = widened(Scalar(0)) - given_as(equation.given, Scalar(0));
    double terms = size_of(equation.given);
    for (const auto& [i, j] : equation.pairs) {
      const auto difference = wide_difference(x[i], j < 0 ? Scalar(0) : x[j]);
      sum = sum + difference * difference;
      const Scalar slope = 2.0 * difference.value();
      terms += std::norm(slope);
      f.jacobian(e, i) = slope;
      if (j >= 0) f.jacobian(e, j) = -slope;
    }
    f.value[e] = sum.value();
    f.value_error[e] = 2 * epsilon * std::abs(f.value[e]) + 128 * epsilon * epsilon * terms;
  }
  return f;
}

template LinearisedSystem<double> linearised(const SquaredDifferences&, const Eigen::VectorXd&);
template LinearisedSystem<std::complex<double>> linearised(const SquaredDifferences&,
                                                           const Eigen::VectorXcd&);

}  // namespace gcs
