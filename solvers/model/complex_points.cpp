#include "solvers/model/complex_points.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// A unit vector along v, of the two the one with a component along v of non-negative real part.
Eigen::Vector3cd normalised(const Eigen::Vector3cd& v) { return v / std::sqrt(bilinear_product(v, v)); }
WideVector normalised(const WideVector& v) { return inverse_sqrt(bilinear_product(v, v)) * v; }

/// The bilinear square of a vector less the given square, rounded after the subtraction.
Complex square_excess(const WideVector& v, DoubleDouble square) {
  DoubleDouble real = -square;
  DoubleDouble half_imaginary{0, 0};
  for (const ComplexDoubleDouble& component : v) {
    real = real + component.re * component.re - component.im * component.im;
    half_imaginary = half_imaginary + component.re * component.im;
  }
  return {real.value(), 2 * half_imaginary.value()};
}

/// From point b to point a.
WideVector difference(const ComplexPoints& points, int a, int b) {
  return wide_difference(Eigen::Vector3cd(points.col(a)), Eigen::Vector3cd(points.col(b)));
}
WideVector difference(const WidePoints& points, int a, int b) {
  return wide_difference(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)]);
}

bool is_in_frame(const ComplexPoints& points, int dimension, const Reference& reference) {
  const bool axis_is = points.col(reference.origin).isZero(0) &&
                       points.col(reference.axis).tail<2>().isZero(0) && points(0, reference.axis).real() > 0;
  return axis_is && (dimension == 2 || reference.plane < 0 ||
                     (points(2, reference.plane) == 0.0 && points(1, reference.plane).real() > 0));
}

/// The part of v across the unit vector x, of length 1.
Eigen::Vector3cd across(const Eigen::Vector3cd& x, const Eigen::Vector3cd& v) {
  return normalised(v - x * bilinear_product(x, v));
}

/// The unit vector of an axis whose part across x is not short: 1 − x_k² add up to 2.
Eigen::Vector3cd some_axis_across(const Eigen::Vector3cd& x) {
  Eigen::Index axis = 0;
  (1.0 - x.array().square()).abs().maxCoeff(&axis);
  return Eigen::Vector3cd::Unit(axis);
}

/// Column of coordinate `axis` of each point (3·point + axis) among the unknowns; −1: it is given.
std::vector<int> unknown_columns(std::span<const DistanceEquation> equations, const std::array<int, 3>& frame,
                                 Eigen::Index points) {
  constexpr int unknown = 0;
  std::vector<int> column(3 * static_cast<std::size_t>(points), -1);
  for (const DistanceEquation& equation : equations)
    for (int point : {equation.a, equation.b})
      for (int axis = 0; axis < 3; ++axis) column[3 * point + axis] = unknown;
  for (int place = 0; place < 3; ++place)
    for (int axis = place; axis < 3; ++axis) column[3 * frame[place] + axis] = -1;
  int next = 0;
  for (int& c : column)
    if (c == unknown) c = next++;
  return column;
}

/// The system at a placement: residuals and Jacobian with rows scaled to 2-norm 1.
struct System {
  Eigen::VectorXcd residual;
  Eigen::MatrixXcd jacobian;
};

template <class Points>
System system_at(std::span<const DistanceEquation> equations, const std::vector<int>& column,
                 const Points& points) {
  const auto m = static_cast<Eigen::Index>(equations.size());
  System system{Eigen::VectorXcd(m), Eigen::MatrixXcd::Zero(m, m)};
  for (Eigen::Index e = 0; e < m; ++e) {
    const auto [a, b, square] = equations[static_cast<std::size_t>(e)];
    const WideVector apart = difference(points, a, b);
    const Eigen::Vector3cd gradient = narrowed(apart);
    system.residual[e] = square_excess(apart, square) / 2.0;
    for (int axis = 0; axis < 3; ++axis) {
      if (const int c = column[3 * a + axis]; c >= 0) system.jacobian(e, c) = gradient[axis];
      if (const int c = column[3 * b + axis]; c >= 0) system.jacobian(e, c) = -gradient[axis];
    }
    const double norm = system.jacobian.row(e).norm();
    if (norm > 0) {
      system.jacobian.row(e) /= norm;
      system.residual[e] /= norm;
    }
  }
  return system;
}

}  // namespace

WidePoints widened(const ComplexPoints& points) {
  WidePoints wide;
  wide.reserve(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) wide.push_back(widened(Eigen::Vector3cd(points.col(i))));
  return wide;
}

ComplexPoints narrowed(const WidePoints& points) {
  ComplexPoints result(3, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index i = 0; i < result.cols(); ++i)
    result.col(i) = narrowed(points[static_cast<std::size_t>(i)]);
  return result;
}

ComplexPoints complex_points(const Figure& figure) {
  ComplexPoints points = figure.points.cast<Complex>();
  if (!figure.is_real()) points.imag() = figure.imaginary;
  return points;
}

Figure complex_figure(const ComplexPoints& points) { return {points.real(), {}, points.imag()}; }

ComplexPoints in_frame(const ComplexPoints& points, int dimension, const Reference& reference) {
  if (is_in_frame(points, dimension, reference)) return points;
  ComplexPoints moved = points.colwise() - Eigen::Vector3cd(points.col(reference.origin));
  const Eigen::Vector3cd x = normalised(moved.col(reference.axis));
  Eigen::Vector3cd y(-x[1], x[0], 0);
  const bool has_plane = dimension == 3 && reference.plane >= 0;
  if (dimension == 3)
    y = across(x, has_plane ? Eigen::Vector3cd(moved.col(reference.plane)) : some_axis_across(x));
  Eigen::Matrix3cd axes;
  axes.row(0) = x.transpose();
  axes.row(1) = y.transpose();
  axes.row(2) = cross_product(x, y).transpose();
  moved = axes * moved;
  moved.col(reference.axis).tail<2>().setZero();
  if (has_plane) moved(2, reference.plane) = 0;
  return moved;
}

WidePoints in_frame(const WidePoints& points, const Reference& reference) {
  const auto from_origin = [&](int point) { return difference(points, point, reference.origin); };
  const WideVector x = normalised(from_origin(reference.axis));
  const WideVector second = from_origin(reference.plane);
  const WideVector y = normalised(wide_difference(second, bilinear_product(x, second) * x));
  const WideVector z = cross_product(x, y);
  WidePoints moved;
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const WideVector v = from_origin(i);
    moved.push_back({bilinear_product(x, v), bilinear_product(y, v), bilinear_product(z, v)});
  }
  auto& on_axis = moved[static_cast<std::size_t>(reference.axis)];
  auto& in_plane = moved[static_cast<std::size_t>(reference.plane)];
  on_axis[1] = on_axis[2] = in_plane[2] = {};
  return moved;
}

Complex squared_distance(const WidePoints& points, int a, int b) {
  const WideVector apart = difference(points, a, b);
  return bilinear_product(apart, apart).value();
}

Complex squared_distance(const ComplexPoints& points, int a, int b) {
  const Eigen::Vector3cd difference = points.col(a) - points.col(b);
  return bilinear_product(difference, difference);
}

Complex squared_distance_excess(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b, DoubleDouble square) {
  return square_excess(wide_difference(a, b), square);
}

Complex squared_distance_excess(const WideVector& a, const WideVector& b, DoubleDouble square) {
  return square_excess(wide_difference(a, b), square);
}

std::optional<std::array<Eigen::Vector3cd, 2>> trilaterate(const std::array<Eigen::Vector3cd, 3>& centers,
                                                           const std::array<Complex, 3>& squares) {
  const Eigen::Vector3cd u = centers[1] - centers[0];
  const Eigen::Vector3cd v = centers[2] - centers[0];
  const Eigen::Vector3cd n = cross_product(u, v);
  const Complex uu = bilinear_product(u, u);
  const Complex uv = bilinear_product(u, v);
  const Complex vv = bilinear_product(v, v);
  const Complex determinant = bilinear_product(n, n);  // of the Gram matrix of u and v
  if (!(std::abs(determinant) > 64 * epsilon * u.squaredNorm() * v.squaredNorm())) return std::nullopt;
  const Complex ru = (squares[0] + uu - squares[1]) / 2.0;
  const Complex rv = (squares[0] + vv - squares[2]) / 2.0;
  const Complex along_u = (vv * ru - uv * rv) / determinant;
  const Complex along_v = (uu * rv - uv * ru) / determinant;
  const Eigen::Vector3cd foot = centers[0] + along_u * u + along_v * v;
  const Complex height = std::sqrt((squares[0] - along_u * ru - along_v * rv) / determinant);
  return std::array<Eigen::Vector3cd, 2>{foot + height * n, foot - height * n};
}

ComplexRefinement refine(std::span<const DistanceEquation> equations, const std::array<int, 3>& frame,
                         ComplexPoints& points) {
  constexpr int most_iterations = 40;  // a double root halves its error: enough for 12 digits
  const std::vector<int> column = unknown_columns(equations, frame, points.cols());
  ComplexRefinement result;
  for (int i = 0; i < most_iterations; ++i) {
    const System system = system_at(equations, column, points);
    const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(system.jacobian);
    const Eigen::VectorXcd correction = lu.solve(system.residual);
    if (!correction.allFinite()) return result;
    for (int c = 0; c < static_cast<int>(column.size()); ++c)
      if (column[c] >= 0) points.data()[c] -= correction[column[c]];
    ++result.iterations;
    const double relative = correction.norm() / points.cwiseAbs().maxCoeff();
    result.reciprocal_condition = lu.rcond();
    const bool falls = i == 0 || relative < 0.9 * result.last_correction;
    result.converged = relative <= 64 * epsilon || (!falls && relative <= 1e-6);
    result.last_correction = relative;
    if (result.converged || (!falls && i > 10)) return result;
  }
  return result;
}

ComplexRefinement refine(std::span<const DistanceEquation> equations, const std::array<int, 3>& frame,
                         WidePoints& points) {
  constexpr int most_iterations = 30;  // the error falls to a tenth or less: from a few digits to `settled`
  constexpr double settled = 1e-18;    // a hundredth of the rounding of doubles
  const std::vector<int> column = unknown_columns(equations, frame, std::ssize(points));
  ComplexRefinement result;
  while (result.iterations < most_iterations && !result.converged) {
    const System system = system_at(equations, column, points);
    const Eigen::PartialPivLU<Eigen::MatrixXcd> lu(system.jacobian);
    const Eigen::VectorXcd correction = lu.solve(system.residual);
    if (!correction.allFinite()) return result;
    double size = 0;
    for (std::size_t c = 0; c < column.size(); ++c) {
      ComplexDoubleDouble& coordinate = points[c / 3][c % 3];
      if (column[c] >= 0) coordinate = coordinate - widened(Complex(correction[column[c]]));
      size = std::max(size, std::abs(coordinate.value()));
    }
    ++result.iterations;
    result.last_correction = correction.norm() / size;
    result.reciprocal_condition = lu.rcond();
    result.converged = result.last_correction <= settled && result.reciprocal_condition > epsilon;
  }
  return result;
}

}  // namespace gcs
