#include "solvers/systems/tangent_systems.hpp"

#include <array>

namespace gcs {
namespace {

using Vector = std::array<RationalPolynomial, 3>;

Vector unknowns_from(int first) {
  return {RationalPolynomial::variable(first), RationalPolynomial::variable(first + 1),
          RationalPolynomial::variable(first + 2)};
}

RationalPolynomial product(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector polynomials(const RationalVector& a) { return {a[0], a[1], a[2]}; }

/// c·c + r_1² − r² − (c·u)², twice c·p.
RationalPolynomial twice_along(const ExactSpheres& spheres, const RationalVector& c, const Rational& square,
                               const Vector& u) {
  return RationalPolynomial(dot(c, c) + spheres[0].square - square) - squared(product(polynomials(c), u));
}

}  // namespace

PolynomialSystem tangent_quadrics(const ExactSpheres& spheres) {
  const Vector p = unknowns_from(0), u = unknowns_from(3);
  PolynomialSystem system{6, {product(p, p) - spheres[0].square}};
  for (std::size_t i = 1; i < 4; ++i) {
    const Vector c = polynomials(spheres[i].center - spheres[0].center);
    const Vector apart{c[0] - p[0], c[1] - p[1], c[2] - p[2]};
    system.equations.push_back(product(apart, apart) - squared(product(c, u)) - spheres[i].square);
  }
  system.equations.push_back(product(p, u));
  system.equations.push_back(product(u, u) - Rational(1));
  return system;
}

std::optional<PolynomialSystem> tangent_cubic(const ExactSpheres& spheres) {
  const Vector u = unknowns_from(0);
  std::array<RationalVector, 3> c;
  for (std::size_t i = 0; i < 3; ++i) c[i] = spheres[i + 1].center - spheres[0].center;
  const Rational volume = dot(c[0], cross(c[1], c[2]));
  if (volume.is_zero()) return std::nullopt;
  Vector p{Rational(0), Rational(0), Rational(0)};
  for (std::size_t i = 0; i < 3; ++i) {  // p is the sum of (c_i·p) times the dual basis
    const RationalVector dual = cross(c[(i + 1) % 3], c[(i + 2) % 3]);
    const RationalPolynomial along = twice_along(spheres, c[i], spheres[i + 1].square, u);
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[axis] = p[axis] + along * (dual[axis] / (Rational(2) * volume));
  }
  return PolynomialSystem{3, {product(u, u) - Rational(1), product(p, u), product(p, p) - spheres[0].square}};
}

}  // namespace gcs
