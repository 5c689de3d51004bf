#include "solvers/certificates/disc_krawczyk.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "solvers/numeric/balls.hpp"

namespace gcs {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

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

Eigen::VectorXd constant(Eigen::Index size, double value) { return Eigen::VectorXd::Constant(size, value); }

template <typename Scalar>
using Vector = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <typename Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// `image`: of a box around x that lies in the one of that radius, where there is one solution.
template <typename Scalar>
Enclosure enclosure_of(const Vector<Scalar>& x, const KrawczykImage<Scalar>& image, double radius) {
  Enclosure enclosure;
  enclosure.unique = radius;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Scalar mid = x[i] - image.move[i];
    const double rounding = 2 * epsilon * std::abs(mid);
    const double spread = (image.spread[i] + rounding) * (1 + 4 * epsilon);
    enclosure.mid.push_back(mid);
    enclosure.radius.emplace_back(spread, std::is_same_v<Scalar, double> ? 0 : spread);
    // The box around x in which there is no other solution holds this one around mid.
    const double moved = std::abs(image.move[i]) * (1 + 4 * epsilon) + rounding;
    enclosure.unique = std::min(enclosure.unique, (radius - moved) * (1 - 2 * epsilon));
  }
  return enclosure;
}

}  // namespace

std::optional<DiscKrawczyk> DiscKrawczyk::of(const QuadraticSystem& system) {
  DiscKrawczyk result;
  result.curvature_ = Eigen::MatrixXd::Zero(system.unknowns, system.unknowns);
  for (const QuadraticEquation& equation : system.equations) {
    Equation own;
    own.given = rounded(equation.given);
    for (const FormProduct& product : equation.products) {
      const auto pair = difference_of(product.left);
      if (!pair || !is_same(product.left, product.right)) return std::nullopt;
      own.pairs.push_back(*pair);
      for (const int unknown : *pair)
        if (unknown >= 0)
          result.curvature_(static_cast<Eigen::Index>(result.equations_.size()), unknown) =
              (*pair)[1] >= 0 ? 4 : 2;
    }
    result.equations_.push_back(std::move(own));
  }
  return result;
}

template <typename Scalar>
LinearisedSystem<Scalar> DiscKrawczyk::linearised(const Vector<Scalar>& x) const {
  const Eigen::Index m = x.size();
  LinearisedSystem<Scalar> f{Vector<Scalar>(m), Eigen::VectorXd(m), Matrix<Scalar>::Zero(m, m)};
  for (Eigen::Index e = 0; e < m; ++e) {
    const Equation& equation = equations_[static_cast<std::size_t>(e)];
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

template <typename Scalar>
std::optional<Enclosure> DiscKrawczyk::prove(const Vector<Scalar>& x) const {
  const Eigen::Index m = x.size();
  const LinearisedSystem<Scalar> f = linearised(x);
  const Matrix<Scalar> inverse = f.jacobian.partialPivLu().inverse();
  if (!inverse.allFinite()) return std::nullopt;
  const auto image_of = [&](const Eigen::VectorXd& box) {
    return krawczyk_image<Scalar>(inverse, f, curvature_ * box.maxCoeff(), box);
  };
  // In a box of this radius the Jacobian moves by half of what the test could bear.
  const double radius = 1 / (2 * (inverse.cwiseAbs() * (curvature_ * constant(m, 1))).maxCoeff());
  KrawczykImage<Scalar> image = image_of(constant(m, radius));
  if (!(image.reach().array() < radius).all()) return std::nullopt;
  // The box shrinks about as fast as its square, down to what rounding leaves.
  while (true) {
    KrawczykImage<Scalar> smaller = image_of(image.reach());
    const bool is_done = !(smaller.spread.maxCoeff() < image.spread.maxCoeff() / 2);
    image = std::move(smaller);
    if (is_done) break;
  }
  return enclosure_of(x, image, radius);
}

std::optional<Enclosure> DiscKrawczyk::prove(const std::vector<std::complex<double>>& x, bool is_real) const {
  const Eigen::Map<const Eigen::VectorXcd> point(x.data(), static_cast<Eigen::Index>(x.size()));
  if (is_real) return prove<double>(Eigen::VectorXd(point.real()));
  return prove<std::complex<double>>(Eigen::VectorXcd(point));
}

}  // namespace gcs
