#include "solvers/reduction/hung_point.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "solvers/model/complex_points.hpp"
#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// |b₁ − b₀|², |b₂ − b₀|² and |b₂ − b₁|² (in the plane the first), and the squared distances from b₀, b₁, b₂.
template <class Number>
struct Squares {
  std::array<Number, 3> base;
  std::array<Number, 3> radii;
};

/// ξ = X/a, η = Y/V and ζ² = D/(a V²), in the plane ζ² = D/a²; V is a times |v|².
template <class Number>
struct Quotients {
  Number a, X, Y, V, D;
  Number largest_term_of_D, largest_term_of_V;  ///< sums of the terms without their signs
};

Complex magnitude(const Complex& x) { return std::abs(x); }

Rational magnitude(const Rational& x) { return x.sign() < 0 ? Rational(0) - x : x; }

template <class Number>
Quotients<Number> in_plane(const Squares<Number>& s) {
  const Number& a = s.base[0];
  const Number X = (s.radii[0] - s.radii[1] + a) / Number(2);
  return {
      a,        X, Number(0), Number(1), s.radii[0] * a - X * X, magnitude(s.radii[0] * a) + magnitude(X * X),
      Number(1)};
}

template <class Number>
Quotients<Number> in_space(const Squares<Number>& s) {
  const auto& [a, b, c] = s.base;
  const Number E = (a + b - c) / Number(2), X = (s.radii[0] - s.radii[1] + a) / Number(2);
  const Number V = a * b - E * E;
  const Number Y = a * (s.radii[0] - s.radii[2] + b) / Number(2) - X * E;
  return {a,
          X,
          Y,
          V,
          s.radii[0] * a * V - X * X * V - Y * Y,
          magnitude(s.radii[0] * a * V) + magnitude(X * X * V) + magnitude(Y * Y),
          magnitude(a * b) + magnitude(E * E)};
}

template <class Number>
Quotients<Number> quotients(int dimension, const Squares<Number>& squares) {
  return dimension == 2 ? in_plane(squares) : in_space(squares);
}

/// Of the terms that cancel in D or V: a height of 1e-4 of the size, where condition numbers reach 1e4.
constexpr double stiff = 1e-8;

constexpr const char* collinear = "the points that it hangs on are collinear";
constexpr const char* without_distance =
    "two of the points that it hangs on are at the distance 0, to rounding";
constexpr const char* nearly_collinear = "the points that it hangs on are collinear, to rounding";
/// Relative to the terms that cancel: what is smaller is undecided.
constexpr double least_margin = 1e-9;

constexpr const char* nearly_flat = "it lies, to rounding, in the plane of the points that it hangs on";

/// What relative errors of the squares make of V, each beside the edge's norm, which may be far larger: edges of complex
/// figures may be isotropic.
double spread_of_V(const Squares<Complex>& squares, const std::array<double, 3>& norms) {
  const double a = std::abs(squares.base[0]), b = std::abs(squares.base[1]);
  return norms[0] * b + norms[1] * a +
         (norms[0] + norms[1] + norms[2]) * std::abs(squares.base[0] + squares.base[1] - squares.base[2]) / 2;
}

HungPlace undecided_place(const char* why) {
  HungPlace place;
  place.undecided = why;
  return place;
}

/// Precondition: the base is given.
std::array<Rational, 3> base_squares(const Scene& scene, const Part& part) {
  std::array<Rational, 3> squares;
  for (int pair = 0; pair < pairs_in(scene.dimension()); ++pair)
    squares[pair] = rational(given_square(scene, part.base_constraints[pair]));
  return squares;
}

}  // namespace

std::string why_not_on_base(const Scene& scene, const Part& part) {
  if (scene.dimension() == 2) return "";
  const Quotients<Rational> q = in_space(Squares<Rational>{base_squares(scene, part), {}});
  if (q.V.sign() == 0) return collinear;
  return std::abs((q.V / q.largest_term_of_V).approximate()) <= least_margin ? nearly_collinear : "";
}

HungPlace exact_place(const Scene& scene, const Part& hung) {
  return precise_place(scene, hung, {base_squares(scene, hung), 0});
}

/// Relative errors of the base's squares are some times as large in D and V beside the terms of these, and in D, of which V
/// is a factor, also as many times as V is smaller than its terms.
HungPlace precise_place(const Scene& scene, const Part& hung, const MeasuredSquares& base) {
  constexpr double growth = 1e3;
  Squares<Rational> squares{base.squares, {}};
  for (int i = 0; i < scene.dimension(); ++i)
    squares.radii[i] = rational(given_square(scene, hung.constraints[i]));
  const Quotients<Rational> q = quotients(scene.dimension(), squares);
  if (q.V.sign() == 0) return undecided_place(collinear);
  const double part_of_V = std::abs((q.V / q.largest_term_of_V).approximate());
  const double part_of_D = std::abs((q.D / q.largest_term_of_D).approximate());
  if (part_of_V < growth * base.error) return undecided_place(nearly_collinear);
  if (part_of_D < growth * base.error / part_of_V) return undecided_place(nearly_flat);
  HungPlace place;
  const Rational square = q.D / (q.a * (scene.dimension() == 2 ? q.a : q.V * q.V));
  place.is_real = square.sign() >= 0;
  place.is_flat = square.sign() == 0;
  place.is_stiff = part_of_D <= stiff || part_of_V <= stiff;
  const double height = place.is_real ? square.approximate_root() : (Rational(0) - square).approximate_root();
  place.coordinates = {(q.X / q.a).approximate(), (q.Y / q.V).approximate(),
                       place.is_real ? Complex(height, 0) : Complex(0, height)};
  return place;
}

HungPlace measured_place(const Scene& scene, const Part& hung, const Simplex& base, double condition) {
  Squares<Complex> squares{};
  std::array<double, 3> norms{};
  for (int pair = 0; pair < pairs_in(scene.dimension()); ++pair) {
    const Eigen::Vector3cd edge = base.col(base_pairs[pair][1]) - base.col(base_pairs[pair][0]);
    squares.base[pair] = (edge.array() * edge.array()).sum();
    norms[pair] = edge.squaredNorm();
  }
  for (int i = 0; i < scene.dimension(); ++i) {
    const double radius = scene.target_lengths()[hung.constraints[i]];
    squares.radii[i] = radius * radius;
  }
  const Quotients<Complex> q = quotients(scene.dimension(), squares);
  double shortest = scene.size();
  for (int pair = 0; pair < pairs_in(scene.dimension()); ++pair)
    shortest = std::min(shortest, std::sqrt(std::abs(squares.base[pair])));
  // Relative errors of the base's edges, a thousand times.
  constexpr double rounding = 1e3 * std::numeric_limits<double>::epsilon();
  const double margin = std::max(least_margin, rounding * condition * scene.size() / shortest);
  if (!(margin < 1) || std::abs(q.a) <= rounding * norms[0]) return undecided_place(without_distance);
  if (std::abs(q.V) <=
      std::max(margin * std::abs(q.largest_term_of_V), rounding * spread_of_V(squares, norms)))
    return undecided_place(nearly_collinear);
  if (std::abs(q.D) <= margin * std::abs(q.largest_term_of_D)) return undecided_place(nearly_flat);
  HungPlace place;
  const Complex square = q.D / (q.a * (scene.dimension() == 2 ? q.a : q.V * q.V));
  place.is_real = base.imag().isZero(0) && square.real() > 0;
  place.is_stiff = std::abs(q.D) <= stiff * std::abs(q.largest_term_of_D) ||
                   std::abs(q.V) <= stiff * std::abs(q.largest_term_of_V);
  place.coordinates = {q.X / q.a, q.Y / q.V, std::sqrt(square)};
  return place;
}

std::vector<int> BasePlacer::constraints_of_points(const Part& part) const {
  const auto is_point = [&](int point) {
    return std::find(part.points.begin(), part.points.end(), point) != part.points.end();
  };
  std::vector<int> result;
  for (const int constraint : part.constraints) {
    const auto& [a, b] = scene_.problem().constraints[constraint].between;
    if (is_point(a) || is_point(b)) result.push_back(constraint);
  }
  return result;
}

Eigen::VectorXcd BasePlacer::excess(const std::vector<int>& constraints, const Simplex& positions) const {
  Eigen::VectorXcd result(static_cast<Eigen::Index>(constraints.size()));
  for (std::size_t row = 0; row < constraints.size(); ++row) {
    const auto& [a, b] = scene_.problem().constraints[constraints[row]].between;
    result[static_cast<Eigen::Index>(row)] =
        squared_distance_excess(positions.col(a), positions.col(b), squares_[constraints[row]]);
  }
  return result;
}

// Next to its base a point is moved further by the rounding of excesses than it is off.
void BasePlacer::refine(const Part& part, Simplex& positions) const {
  constexpr int steps = 2;          // of quadratic convergence from a relative error of 1e-6 at most
  constexpr double longest = 1e-3;  // of the way from the base: more is no refinement
  const int dimension = scene_.dimension();
  const std::vector<int> constraints = constraints_of_points(part);
  const auto unknowns = dimension * static_cast<Eigen::Index>(part.points.size());
  const auto column_of = [&](int point) -> Eigen::Index {
    const auto found = std::find(part.points.begin(), part.points.end(), point);
    return found == part.points.end() ? -1 : dimension * (found - part.points.begin());
  };
  Eigen::VectorXcd left = excess(constraints, positions);
  for (int step = 0; step < steps; ++step) {
    Eigen::MatrixXcd jacobian = Eigen::MatrixXcd::Zero(unknowns, unknowns);
    for (std::size_t row = 0; row < constraints.size(); ++row) {
      const auto& [a, b] = scene_.problem().constraints[constraints[row]].between;
      const Eigen::VectorXcd slope = 2 * (positions.col(a) - positions.col(b)).head(dimension);
      if (column_of(a) >= 0)
        jacobian.row(static_cast<Eigen::Index>(row)).segment(column_of(a), dimension) = slope.transpose();
      if (column_of(b) >= 0)
        jacobian.row(static_cast<Eigen::Index>(row)).segment(column_of(b), dimension) = -slope.transpose();
    }
    const Eigen::VectorXcd correction = jacobian.partialPivLu().solve(left);
    const Simplex from_base = columns(positions, part.points).colwise() - positions.col(part.base.front());
    if (!(correction.norm() <= longest * from_base.norm())) return;
    Simplex next = positions;
    for (const int point : part.points)
      next.col(point).head(dimension) -= correction.segment(column_of(point), dimension);
    const Eigen::VectorXcd left_next = excess(constraints, next);
    if (!(left_next.norm() < left.norm())) return;
    positions = std::move(next);
    left = left_next;
  }
}

void BasePlacer::place(const Part& part, const std::vector<SimplexCoordinates>& coordinates, double side,
                       bool is_flat, Simplex& positions) const {
  const SimplexFrame frame(columns(positions, part.base));
  for (std::size_t i = 0; i < part.points.size(); ++i) {
    SimplexCoordinates there = coordinates[i];
    there[2] *= side;
    positions.col(part.points[i]) = frame.point(there);
  }
  if (!is_flat) refine(part, positions);
}

}  // namespace gcs
