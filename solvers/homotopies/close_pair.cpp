#include "solvers/homotopies/close_pair.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <limits>

#include "solvers/figures/complex_distances.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// Where Newton's method settles, if it does so no further than `furthest` from its start.
std::optional<Eigen::VectorXcd> settled(const ComplexDistances& equations, const Eigen::VectorXcd& start,
                                        double furthest) {
  constexpr int most_steps = 12;
  constexpr double last_step = 1e-6;  // of the way allowed: the next one is below the rounding
  Eigen::VectorXcd x = start;
  for (int i = 0; i < most_steps; ++i) {
    const Eigen::VectorXcd step = equations.jacobian(x).partialPivLu().solve(equations.value(x));
    x -= step;
    if (!((x - start).norm() <= furthest)) return std::nullopt;
    const double rounding = 4 * std::numeric_limits<double>::epsilon() * x.norm();
    if (step.norm() <= std::max(rounding, last_step * furthest)) return x;
  }
  return std::nullopt;
}

ComplexVectorX listed(const Eigen::VectorXcd& x) { return {x.begin(), x.end()}; }

}  // namespace

std::optional<std::array<ComplexVectorX, 2>> close_pair(const DistanceSystem& system,
                                                        const std::vector<DoubleDouble>& squares,
                                                        const ComplexVectorX& mean) {
  const ComplexDistances equations(system, squares);
  const Eigen::VectorXcd middle = Eigen::Map<const Eigen::VectorXcd>(mean.data(), system.unknowns());
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(equations.jacobian(middle),
                                               Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXcd v = svd.matrixV().rightCols<1>(), w = svd.matrixU().rightCols<1>();
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
