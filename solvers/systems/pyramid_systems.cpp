#include "solvers/systems/pyramid_systems.hpp"

#include <array>
#include <cmath>

#include "solvers/octahedron/pair_entries.hpp"

namespace gcs {
namespace {

using Polynomial = RationalPolynomial;
using Complex = std::complex<double>;

/// Squared lengths, and r5. Points by their numbers in the paper less one; the apex is 4.
class ExactPyramid {
 public:
  ExactPyramid(const Scene& scene, const Pyramid& pyramid)
      : squares_(scene), pyramid_(pyramid), line_(scene.point_count()), points_(scene.point_count()) {
    const Rational square = radius_square(4);
    const std::optional<Rational> root = square.root();
    r5_ = root ? *root : Rational::from_double(square.approximate_root());
  }

  int entity(std::size_t point) const { return point < 4 ? pyramid_.cycle[point] : pyramid_.apex; }
  Rational radius_square(std::size_t point) const { return squares_(entity(point), line_); }
  /// The apex included.
  Rational square(std::size_t p, std::size_t q) const { return squares_(entity(p), entity(q)); }
  const Rational& r5() const { return r5_; }
  /// k_ij
  Rational product(std::size_t i, std::size_t j) const {
    return (square(i, 4) + square(j, 4) - square(i, j)) / Rational(2);
  }

  Reference reference() const {
    Reference result;
    result.line = line_;
    result.height = pyramid_.apex;
    return result;
  }

  /// The apex, and 0 for the others.
  ComplexPoints apex() const {
    ComplexPoints placed = ComplexPoints::Zero(3, points_);
    placed(2, pyramid_.apex) = r5_.approximate();
    return placed;
  }

  std::string why_none() const {
    return r5_.is_zero() ? "the apex is on the line, which puts it on no side of it" : "";
  }

 private:
  ExactEntries squares_;
  Pyramid pyramid_;
  int line_, points_;
  Rational r5_;
};

struct Place {
  Polynomial x, y, z;
};

Polynomial variable(int number) { return Polynomial::variable(number); }

/// y² + z² − r²
Polynomial cylinder(const ExactPyramid& pyramid, std::size_t i, const Place& p) {
  return squared(p.y) + squared(p.z) - pyramid.radius_square(i);
}

/// x² + y² + (z − r5)² − d²
Polynomial spoke(const ExactPyramid& pyramid, std::size_t i, const Place& p) {
  return squared(p.x) + squared(p.y) + squared(p.z - pyramid.r5()) - pyramid.square(i, 4);
}

/// The equations (8) and (9) with z2 and z4 eliminated.
class Parametrised {
 public:
  explicit Parametrised(const ExactPyramid& pyramid) : pyramid_(pyramid) {}

  PolynomialSystem system() const {
    PolynomialSystem result{10, {}};
    const Rational r5 = pyramid_.r5(), r5_square = r5 * r5;
    result.equations = {squared(x1_) - pyramid_.square(0, 4) + pyramid_.radius_square(0) + r5_square -
                            t_ * (Rational(2) * r5),
                        squared(y1_) + squared(t_) - pyramid_.radius_square(0)};
    for (const std::size_t i : {std::size_t{1}, std::size_t{3}}) {
      result.equations.push_back(on_cylinder(i));
      result.equations.push_back(on_sphere(i));
    }
    for (const std::size_t i : {std::size_t{1}, std::size_t{3}}) result.equations.push_back(side(i));
    result.equations.push_back(cylinder(pyramid_, 2, third_));
    result.equations.push_back(spoke(pyramid_, 2, third_));
    return result;
  }

 private:
  const Place& place(std::size_t i) const { return i == 1 ? second_ : fourth_; }
  Polynomial height() const { return t_ - pyramid_.r5(); }
  /// k_1i − x1 x_i − y1 y_i, which is (t − r5)(z_i − r5).
  Polynomial rest(std::size_t i) const {
    return Polynomial(pyramid_.product(0, i)) - x1_ * place(i).x - y1_ * place(i).y;
  }
  /// D1 or D3.
  Polynomial on_cylinder(std::size_t i) const {
    return squared(height()) * squared(place(i).y) * Rational(4) +
           squared(height() * (Rational(2) * pyramid_.r5()) + rest(i) * Rational(2)) -
           squared(height()) * (Rational(4) * pyramid_.radius_square(i));
  }
  /// D2 or D4.
  Polynomial on_sphere(std::size_t i) const {
    const Rational constant =
        pyramid_.radius_square(i) - pyramid_.r5() * pyramid_.r5() - pyramid_.square(i, 4);
    return height() * (squared(place(i).x) + constant) - rest(i) * (Rational(2) * pyramid_.r5());
  }
  /// D5 or D6.
  Polynomial side(std::size_t i) const {
    const Place& p = place(i);
    return height() * (p.x * third_.x + p.y * third_.y - pyramid_.product(i, 2)) +
           rest(i) * (third_.z - pyramid_.r5());
  }

  const ExactPyramid& pyramid_;
  Polynomial x1_ = variable(0), y1_ = variable(1), t_ = variable(2);
  Place second_{variable(3), variable(4), Rational(0)}, fourth_{variable(5), variable(6), Rational(0)};
  Place third_{variable(7), variable(8), variable(9)};
};

/// x1 … z3 of a zero of the parametrised system, as points.
ComplexPoints placed(const ExactPyramid& pyramid, const ComplexVectorX& zero) {
  ComplexPoints points = pyramid.apex();
  const Complex r5 = pyramid.r5().approximate(), x1 = zero[0], y1 = zero[1], t = zero[2];
  points.col(pyramid.entity(0)) << x1, y1, t;
  for (const auto& [i, first] : {std::pair<std::size_t, std::size_t>{1, 3}, {3, 5}}) {
    const Complex x = zero[first], y = zero[first + 1];
    points.col(pyramid.entity(i)) << x, y,
        r5 + (pyramid.product(0, i).approximate() - x1 * x - y1 * y) / (t - r5);
  }
  points.col(pyramid.entity(2)) << zero[7], zero[8], zero[9];
  return points;
}

}  // namespace

SystemOrReason pyramid_quadrics(const Scene& scene, const Pyramid& pyramid) {
  const ExactPyramid exact(scene, pyramid);
  if (std::string reason = exact.why_none(); !reason.empty()) return {std::nullopt, std::move(reason)};
  std::array<Place, 4> p{
      Place{variable(0), variable(1), variable(2)}, Place{variable(3), variable(4), variable(5)},
      Place{variable(6), variable(7), variable(8)}, Place{variable(9), variable(10), variable(11)}};
  WrittenSystem written;
  written.equations.unknowns = 12;
  auto& equations = written.equations.equations;
  for (std::size_t i = 0; i < 4; ++i) equations.push_back(cylinder(exact, i, p[i]));
  for (std::size_t i = 0; i < 4; ++i) equations.push_back(spoke(exact, i, p[i]));
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    equations.push_back(squared(p[i].x - p[j].x) + squared(p[i].y - p[j].y) + squared(p[i].z - p[j].z) -
                        exact.square(i, j));
  }
  written.reference = exact.reference();
  written.mirror_images = 4;
  written.place = [exact](const ComplexVectorX& zero) {
    ComplexPoints points = exact.apex();
    for (std::size_t i = 0; i < 4; ++i)
      points.col(exact.entity(i)) << zero[3 * i], zero[3 * i + 1], zero[3 * i + 2];
    return points;
  };
  return {std::move(written), ""};
}

SystemOrReason pyramid_parametrised(const Scene& scene, const Pyramid& pyramid) {
  const ExactPyramid exact(scene, pyramid);
  if (std::string reason = exact.why_none(); !reason.empty()) return {std::nullopt, std::move(reason)};
  WrittenSystem written;
  written.equations = Parametrised(exact).system();
  written.reference = exact.reference();
  written.mirror_images = 4;
  written.place = [exact](const ComplexVectorX& zero) { return placed(exact, zero); };
  // Singular ends are right to 1e-7.
  written.is_extraneous = [r5 = exact.r5().approximate()](const ComplexVectorX& zero) {
    return std::abs(zero[2] - r5) <= 1e-5 * (1 + std::abs(r5));
  };
  return {std::move(written), ""};
}

}  // namespace gcs
