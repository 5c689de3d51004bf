#include "solvers/complex_tracking/close_pair.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <limits>

#include "solvers/numeric/complex_double_double.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;
using Vector = Eigen::VectorXcd;
using Matrix = Eigen::MatrixXcd;

/// The distance equations at complex coordinates.
class ComplexDistances {
 public:
  ComplexDistances(const DistanceSystem& system, const std::vector<DoubleDouble>& squares)
      : system_(system), squares_(squares) {}

  /// (p_a − p_b)·(p_a − p_b)/2 − a²/2
  Vector value(const Vector& x) const {
    const Eigen::Matrix3Xd real = system_.figure(x.real()).points, imaginary = height(x);
    Vector result(system_.equations());
    for (int e = 0; e < system_.equations(); ++e) {
      const auto [a, b] = system_.edges()[e];
      auto sum = widened(Complex(0));
      for (int axis = system_.is_line(b) ? 1 : 0; axis < system_.dimension(); ++axis) {
        const auto at = [&](int point) {
          return system_.is_line(point) ? Complex(0) : Complex(real(axis, point), imaginary(axis, point));
        };
        const auto difference = wide_difference(at(a), at(b));
        sum = sum + difference * difference;
      }
      result[e] = (sum - squares_[e]).value() / 2.0;
    }
    return result;
  }

  Matrix jacobian(const Vector& x) const {
    Eigen::MatrixXd real(system_.equations(), system_.unknowns()), imaginary = real;
    system_.jacobian(system_.figure(x.real()).points, real);
    system_.jacobian(height(x), imaginary);
    return real + Complex(0, 1) * imaginary;
  }

 private:
  Eigen::Matrix3Xd height(const Vector& x) const {
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, system_.point_count());
    system_.place(x.imag(), points);
    return points;
  }

  const DistanceSystem& system_;
  const std::vector<DoubleDouble>& squares_;
};

/// Where Newton's method settles, if it does so no further than `furthest` from its start.
std::optional<Vector> settled(const ComplexDistances& equations, const Vector& start, double furthest) {
  constexpr int most_steps = 12;
  constexpr double last_step = 1e-6;  // of the way allowed: the next one is below the rounding
  Vector x = start;
  for (int i = 0; i < most_steps; ++i) {
    const Vector step = equations.jacobian(x).partialPivLu().solve(equations.value(x));
    x -= step;
    if (!((x - start).norm() <= furthest)) return std::nullopt;
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * x.norm();
    if (step.norm() <= std::max(rounding, last_step * furthest)) return x;
  }
  return std::nullopt;
}

ComplexVectorX listed(const Vector& x) { return {x.begin(), x.end()}; }

}  // namespace

std::optional<std::array<ComplexVectorX, 2>> close_pair(const DistanceSystem& system,
                                                        const std::vector<DoubleDouble>& squares,
                                                        const ComplexVectorX& mean) {
  const ComplexDistances equations(system, squares);
  const Vector middle = Eigen::Map<const Vector>(mean.data(), system.unknowns());
  const Eigen::JacobiSVD<Matrix> svd(equations.jacobian(middle), Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector v = svd.matrixV().rightCols<1>(), w = svd.matrixU().rightCols<1>();
  const Complex value = w.dot(equations.value(middle));
  // f is quadratic: f''(v, v) is the change of its Jacobian along v, times v.
  const Complex bend = w.dot((equations.jacobian(middle + v) - equations.jacobian(middle)) * v);
  const Complex s = std::sqrt(-2.0 * value / bend);
  const double half = std::abs(s) / 2;  // of the way to the middle: no solution strays to the other one
  const auto one = settled(equations, middle + s * v, half), other = settled(equations, middle - s * v, half);
  if (!one || !other) return std::nullopt;
  return std::array{listed(*one), listed(*other)};
}

}  // namespace gcs
