#include "solvers/systems/octahedron_systems.hpp"

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "solvers/octahedron/exact_determinants.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

constexpr std::array<std::array<std::size_t, 2>, 3> edges_of_three{{{0, 1}, {1, 2}, {2, 0}}};

/// The triangle abc in the coordinates X and Y, and which points are where.
struct Base {
  Base(const Scene& scene, const Octahedron& octahedron) : squares(scene), points(scene.point_count()) {
    for (std::size_t i = 0; i < 3; ++i) {
      corner[i] = octahedron.pair[i][0];
      free[i] = octahedron.pair[i][1];
    }
    x_square = squares(corner[0], corner[1]);
    const Rational along =
        (x_square + squares(corner[0], corner[2]) - squares(corner[1], corner[2])) / Rational(2);
    y_square = squares(corner[0], corner[2]) - along * along / x_square;
    x = {Rational(0), x_square, along};
    y = {Rational(0), Rational(0), y_square};
  }

  Reference reference() const {
    Reference result;
    result.origin = corner[0];
    result.axis = corner[1];
    result.plane = corner[2];
    return result;
  }

  /// The corners, and 0 for the others.
  ComplexPoints corners() const {
    ComplexPoints placed = ComplexPoints::Zero(3, points);
    for (std::size_t i = 0; i < 3; ++i) placed.col(corner[i]).head<2>() = plane_place(i).cast<Complex>();
    return placed;
  }

  Eigen::Vector2d plane_place(std::size_t i) const {
    return {x[i].approximate() / x_square.approximate_root(),
            y[i].approximate() / y_square.approximate_root()};
  }

  ExactEntries squares;
  int points;
  std::array<int, 3> corner{}, free{};  ///< a, b, c and a', b', c'
  Rational x_square, y_square;          ///< |ab|² and y_c²
  std::array<Rational, 3> x, y;         ///< X and Y of the corners
};

std::string why_no_base(const Base& base) {
  return base.y_square.sign() > 0 ? "" : "the face that the other points are placed on is flat";
}

RationalPolynomial unknown(std::size_t point, std::size_t axis) {
  return RationalPolynomial::variable(static_cast<int>(3 * point + axis));
}

/// X²/|ab|² + Y²/y_c² + z² − square
RationalPolynomial distance_equation(const Base& base, const std::array<RationalPolynomial, 3>& difference,
                                     const Rational& square) {
  return squared(difference[0]) * (Rational(1) / base.x_square) +
         squared(difference[1]) * (Rational(1) / base.y_square) + squared(difference[2]) - square;
}

/// A circle about the edge of two corners: centre + radius (cos α · inward + sin α · z).
struct Circle {
  Eigen::Vector2d centre, inward;
  double radius = 0;

  /// Of free point i.
  Circle(const Base& base, std::size_t i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Rational edge = base.squares(base.corner[j], base.corner[k]);
    const Rational to_j = base.squares(base.free[i], base.corner[j]);
    const Rational share = (to_j + edge - base.squares(base.free[i], base.corner[k])) / (Rational(2) * edge);
    const Rational square = to_j - share * share * edge;
    const Eigen::Vector2d from = base.plane_place(j), along = base.plane_place(k) - from;
    centre = from + share.approximate() * along;
    inward = Eigen::Vector2d(-along.y(), along.x()).normalized();
    radius = square.sign() > 0 ? square.approximate_root() : 0;
  }

  Eigen::Vector3cd at(Complex t) const {
    const Complex size = 1.0 + t * t, cosine = (1.0 - t * t) / size, sine = 2.0 * t / size;
    Eigen::Vector3cd place;
    place.head<2>() = centre.cast<Complex>() + radius * cosine * inward.cast<Complex>();
    place[2] = radius * sine;
    return place;
  }
};

RationalPolynomial constant(double value) { return Rational::from_double(value); }

RationalPolynomial quartic(const Circle& p, const Circle& q, double square, int t, int s) {
  const Eigen::Vector2d apart = p.centre - q.centre;
  const double k = apart.squaredNorm() + p.radius * p.radius + q.radius * q.radius - square;
  const double a = 2 * p.radius * p.inward.dot(apart), b = -2 * q.radius * q.inward.dot(apart);
  const double f = -2 * p.radius * q.radius, g = f * p.inward.dot(q.inward);
  const RationalPolynomial x = RationalPolynomial::variable(t), y = RationalPolynomial::variable(s);
  return constant(k + a + b + g) + constant(k - a + b - g) * x * x + constant(k + a - b - g) * y * y +
         constant(k - a - b + g) * x * x * y * y + constant(4 * f) * x * y;
}

}  // namespace

SystemOrReason octahedron_quadrics(const Scene& scene, const Octahedron& octahedron) {
  const Base base(scene, octahedron);
  if (std::string reason = why_no_base(base); !reason.empty()) return {std::nullopt, std::move(reason)};
  WrittenSystem written;
  written.equations.unknowns = 9;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (i != j)
        written.equations.equations.push_back(
            distance_equation(base, {unknown(i, 0) - base.x[j], unknown(i, 1) - base.y[j], unknown(i, 2)},
                              base.squares(base.free[i], base.corner[j])));
  for (const auto& [i, j] : edges_of_three)
    written.equations.equations.push_back(distance_equation(
        base, {unknown(i, 0) - unknown(j, 0), unknown(i, 1) - unknown(j, 1), unknown(i, 2) - unknown(j, 2)},
        base.squares(base.free[i], base.free[j])));
  written.reference = base.reference();
  written.mirror_images = 2;
  written.place = [base, x_scale = base.x_square.approximate_root(),
                   y_scale = base.y_square.approximate_root()](const ComplexVectorX& zero) {
    ComplexPoints points = base.corners();
    for (std::size_t i = 0; i < 3; ++i)
      points.col(base.free[i]) << zero[3 * i] / x_scale, zero[3 * i + 1] / y_scale, zero[3 * i + 2];
    return points;
  };
  return {std::move(written), ""};
}

PolynomialSystem octahedron_determinants(const Scene& scene, const Octahedron& octahedron) {
  const SymbolicEntries entries(scene, octahedron);
  const auto [a, a2] = octahedron.pair[0];
  const auto [b, b2] = octahedron.pair[1];
  const auto [c, c2] = octahedron.pair[2];
  return {2, {gram_determinant(entries, c, {a, a2, b, b2}), gram_determinant(entries, c2, {a, a2, b, b2})}};
}

SystemOrReason octahedron_quartics(const Scene& scene, const Octahedron& octahedron) {
  const Base base(scene, octahedron);
  if (std::string reason = why_no_base(base); !reason.empty()) return {std::nullopt, std::move(reason)};
  const std::array<Circle, 3> circles{Circle(base, 0), Circle(base, 1), Circle(base, 2)};
  for (const Circle& circle : circles)
    if (circle.radius == 0) return {std::nullopt, "a face is flat, whose point turns on no circle"};
  WrittenSystem written;
  written.equations.unknowns = 3;
  for (const auto& [i, j] : edges_of_three)
    written.equations.equations.push_back(quartic(circles[i], circles[j],
                                                  base.squares(base.free[i], base.free[j]).approximate(),
                                                  static_cast<int>(i), static_cast<int>(j)));
  written.reference = base.reference();
  written.mirror_images = 2;
  written.place = [base, circles](const ComplexVectorX& zero) {
    ComplexPoints points = base.corners();
    for (std::size_t i = 0; i < 3; ++i) points.col(base.free[i]) = circles[i].at(zero[i]);
    return points;
  };
  return {std::move(written), ""};
}

}  // namespace gcs
