#include "solvers/model/complex_points.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <vector>

#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;
constexpr double rounding = std::numeric_limits<double>::epsilon();

/// Without conjugation, unlike Eigen's dot.

/// A unit vector along v, of the two the one with a component along v of non-negative real part.
Eigen::Vector3cd normalised(const Eigen::Vector3cd& v) { return v / std::sqrt(bilinear_product(v, v)); }

bool is_in_frame(const ComplexPoints& points, int dimension, const Reference& reference) {
  const bool axis_is = points.col(reference.origin).isZero(0) &&
                       points.col(reference.axis).tail<2>().isZero(0) && points(0, reference.axis).real() > 0;
  return axis_is &&
         (dimension == 2 || (points(2, reference.plane) == 0.0 && points(1, reference.plane).real() > 0));
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

System system_at(std::span<const DistanceEquation> equations, const std::vector<int>& column,
                 const ComplexPoints& points) {
  const auto m = static_cast<Eigen::Index>(equations.size());
  System system{Eigen::VectorXcd(m), Eigen::MatrixXcd::Zero(m, m)};
  for (Eigen::Index e = 0; e < m; ++e) {
    const auto [a, b, square] = equations[static_cast<std::size_t>(e)];
    const Eigen::Vector3cd difference = points.col(a) - points.col(b);
    system.residual[e] = squared_distance_excess(points.col(a), points.col(b), square) / 2.0;
    for (int axis = 0; axis < 3; ++axis) {
      if (const int c = column[3 * a + axis]; c >= 0) system.jacobian(e, c) = difference[axis];
      if (const int c = column[3 * b + axis]; c >= 0) system.jacobian(e, c) = -difference[axis];
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
  if (dimension == 3) {
    const Eigen::Vector3cd second = moved.col(reference.plane);
    y = normalised(second - x * bilinear_product(x, second));
  }
  Eigen::Matrix3cd axes;
  axes.row(0) = x.transpose();
  axes.row(1) = y.transpose();
  axes.row(2) = cross_product(x, y).transpose();
  moved = axes * moved;
  moved.col(reference.axis).tail<2>().setZero();
  if (dimension == 3) moved(2, reference.plane) = 0;
  return moved;
}

Complex squared_distance(const ComplexPoints& points, int a, int b) {
  const Eigen::Vector3cd difference = points.col(a) - points.col(b);
  return bilinear_product(difference, difference);
}

Complex squared_distance_excess(const Eigen::Vector3cd& a, const Eigen::Vector3cd& b, DoubleDouble square) {
  DoubleDouble real = -square;
  DoubleDouble imaginary{0, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleDouble re = two_sum(a[axis].real(), -b[axis].real());
    const DoubleDouble im = two_sum(a[axis].imag(), -b[axis].imag());
    real = real + re * re - im * im;
    imaginary = imaginary + re * im + im * re;
  }
  return {real.value(), imaginary.value()};
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
  if (!(std::abs(determinant) > 64 * rounding * u.squaredNorm() * v.squaredNorm())) return std::nullopt;
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
    result.converged = relative <= 64 * rounding || (!falls && relative <= 1e-6);
    result.last_correction = relative;
    if (result.converged || (!falls && i > 10)) return result;
  }
  return result;
}

}  // namespace gcs
