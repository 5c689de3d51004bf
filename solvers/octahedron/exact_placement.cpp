#include "solvers/octahedron/exact_placement.hpp"

#include <array>
#include <optional>

#include "solvers/octahedron/exact_determinants.hpp"
#include "solvers/octahedron/exact_elimination.hpp"

namespace gcs {
namespace {

constexpr slong bits = 512;

/// A complex number in a ball.
class Number {
 public:
  Number() { acb_init(value_); }
  explicit Number(acb_srcptr ball) : Number() { acb_set(value_, ball); }
  explicit Number(const Rational& exact) : Number() { acb_set_fmpq(value_, exact.raw(), bits); }
  Number(const Number& other) : Number(static_cast<acb_srcptr>(other.value_)) {}
  Number& operator=(const Number& other) {
    acb_set(value_, other.value_);
    return *this;
  }
  ~Number() { acb_clear(value_); }

  /// The one with Re ≥ 0.
  Number root() const {
    Number result;
    acb_sqrt(result.value_, value_, bits);
    return result;
  }
  bool may_be_zero() const { return acb_contains_zero(value_) != 0; }
  std::complex<double> rounded() const { return rounded_midpoint(value_); }

  friend Number operator+(const Number& a, const Number& b) { return apply(acb_add, a, b); }
  friend Number operator-(const Number& a, const Number& b) { return apply(acb_sub, a, b); }
  friend Number operator*(const Number& a, const Number& b) { return apply(acb_mul, a, b); }
  friend Number operator/(const Number& a, const Number& b) { return apply(acb_div, a, b); }

 private:
  static Number apply(void (*operation)(acb_t, const acb_t, const acb_t, slong), const Number& a,
                      const Number& b) {
    Number result;
    operation(result.value_, a.value_, b.value_, bits);
    return result;
  }

  acb_t value_;
};

using Vector = std::array<Number, 3>;

Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vector operator*(const Number& factor, const Vector& a) {
  return {factor * a[0], factor * a[1], factor * a[2]};
}
Number product(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector unit(const Vector& a) { return Number(Rational(1)) / product(a, a).root() * a; }

/// As trilaterate of complex_points.hpp.
std::optional<std::array<Vector, 2>> points_at(const std::array<Vector, 3>& centers,
                                               const std::array<Number, 3>& squares) {
  const Number two(Rational(2));
  const Vector u = centers[1] - centers[0], w = centers[2] - centers[0], n = cross(u, w);
  const Number uu = product(u, u), uw = product(u, w), ww = product(w, w), determinant = product(n, n);
  if (determinant.may_be_zero()) return std::nullopt;
  const Number ru = (squares[0] + uu - squares[1]) / two, rw = (squares[0] + ww - squares[2]) / two;
  const Number along_u = (ww * ru - uw * rw) / determinant, along_w = (uu * rw - uw * ru) / determinant;
  const Vector foot = centers[0] + along_u * u + along_w * w;
  const Vector up = ((squares[0] - along_u * ru - along_w * rw) / determinant).root() * n;
  return std::array{foot + up, foot - up};
}

/// The coefficients of 1, Y and Y² at X.
std::array<Number, 3> coefficients_at(const RationalPolynomial& determinant, const Number& at) {
  const std::array<Number, 3> powers{Number(Rational(1)), at, at * at};
  std::array<Number, 3> result;
  for (const RationalPolynomial::Term& term : determinant.terms()) {
    Number& sum = result[static_cast<std::size_t>(term.exponents[1])];
    sum = sum + Number(term.coefficient) * powers[static_cast<std::size_t>(term.exponents[0])];
  }
  return result;
}

class ExactPlacer {
 public:
  ExactPlacer(const Scene& scene, const Octahedron& octahedron)
      : scene_(scene), octahedron_(octahedron), entries_(scene), points_(scene.problem().points.size()) {
    const SymbolicEntries symbolic(scene, octahedron);
    const auto [a, a2] = octahedron.pair[0];
    const auto [b, b2] = octahedron.pair[1];
    const auto [c, c2] = octahedron.pair[2];
    first_ = gram_determinant(symbolic, c, {a, a2, b, b2});
    second_ = gram_determinant(symbolic, c2, {a, a2, b, b2});
    const Number length = square(a, b).root(),
                 along = (square(a, b) + square(a, c) - square(b, c)) / (Number(Rational(2)) * length);
    at(b)[0] = length;
    at(c)[0] = along;
    at(c)[1] = (square(a, c) - along * along).root();
  }

  /// Nothing where several figures, or none, have this diagonal.
  std::optional<ComplexPoints> place(const Number& diagonal) {
    const std::array<Number, 3> f = coefficients_at(first_, diagonal), g = coefficients_at(second_, diagonal);
    const Number slope = g[2] * f[1] - f[2] * g[1];
    if (slope.may_be_zero()) return std::nullopt;
    const Number other = (f[2] * g[0] - g[2] * f[0]) / slope;
    const auto [a, a2] = octahedron_.pair[0];
    const auto [b, b2] = octahedron_.pair[1];
    const auto [c, c2] = octahedron_.pair[2];
    const auto first = points_at({at(a), at(b), at(c)}, {diagonal, square(a2, b), square(a2, c)});
    const auto second = points_at({at(a), at(b), at(c)}, {square(b2, a), other, square(b2, c)});
    if (!first || !second) return std::nullopt;
    at(a2) = (*first)[0];
    if (!take_one_of(*second, b2, a2)) return std::nullopt;
    const auto last = points_at({at(a), at(b), at(a2)}, {square(c2, a), square(c2, b), square(c2, a2)});
    if (!last || !take_one_of(*last, c2, b2)) return std::nullopt;
    return in_frame();
  }

 private:
  Vector& at(int point) { return points_[static_cast<std::size_t>(point)]; }
  Number square(int p, int q) const { return Number(entries_(p, q)); }

  /// The one that has its given distance from another point.
  bool take_one_of(const std::array<Vector, 2>& both, int point, int other) {
    const auto may_be = [&](const Vector& position) {
      const Vector way = position - at(other);
      return (product(way, way) - square(point, other)).may_be_zero();
    };
    const bool first = may_be(both[0]), second = may_be(both[1]);
    if (first == second) return false;
    at(point) = both[first ? 0 : 1];
    return true;
  }

  /// As Reference says.
  ComplexPoints in_frame() {
    const Reference& reference = scene_.reference();
    const Vector origin = at(reference.origin);
    const Vector e = unit(at(reference.axis) - origin), beside = at(reference.plane) - origin;
    const Vector f = unit(beside - product(beside, e) * e), g = cross(e, f);
    ComplexPoints rounded(3, static_cast<Eigen::Index>(points_.size()));
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vector from = points_[i] - origin;
      rounded.col(static_cast<Eigen::Index>(i)) << product(from, e).rounded(), product(from, f).rounded(),
          product(from, g).rounded();
    }
    rounded.col(reference.origin).setZero();
    rounded.col(reference.axis).tail<2>().setZero();
    rounded(2, reference.plane) = 0;
    return rounded;
  }

  const Scene& scene_;
  const Octahedron& octahedron_;
  ExactEntries entries_;
  RationalPolynomial first_ = Rational(0), second_ = Rational(0);
  std::vector<Vector> points_;
};

}  // namespace

std::vector<ComplexPoints> exactly_placed(const Scene& scene, const Octahedron& octahedron) {
  std::vector<ComplexPoints> figures;
  const IntegerPolynomial diagonal = diagonal_polynomial(scene, octahedron);
  if (diagonal.is_zero()) return figures;
  ExactPlacer placer(scene, octahedron);
  const BallMatrix roots = diagonal.simple_roots(bits);
  for (slong i = 0; i < roots.rows(); ++i)
    if (std::optional<ComplexPoints> figure = placer.place(Number(roots(i, 0))))
      figures.push_back(*std::move(figure));
  return figures;
}

}  // namespace gcs
