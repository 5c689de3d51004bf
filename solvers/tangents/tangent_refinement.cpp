#include "solvers/tangents/tangent_refinement.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/numeric/complex_double_double.hpp"
#include "solvers/numeric/dense_factors.hpp"

namespace gcs {
namespace {

template <class Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
template <class Scalar>
using Vector6 = Eigen::Matrix<Scalar, 6, 1>;
template <class Scalar>
using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;
/// Whose factors are compiled once (numeric/compiled_once.hpp).
template <class Scalar>
using Dense = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

template <class Scalar>
auto wide_square(const Scalar& a) {
  return widened(a) * widened(a);
}

/// |w|² − (w·u)² − square
template <class Scalar>
Scalar squared_distance_error(const Vector3<Scalar>& center, const Tangent<Scalar>& line,
                              DoubleDouble square) {
  auto along = widened(Scalar(0));
  auto sum = widened(Scalar(0));
  for (int axis = 0; axis < 3; ++axis) {
    const auto w = wide_difference(center[axis], line.point[axis]);
    sum = sum + w * w;
    along = along + w * widened(line.direction[axis]);
  }
  return (sum - along * along - square).value();
}

template <class Scalar>
Vector6<Scalar> residual(const FourSpheres& spheres, const Tangent<Scalar>& line) {
  auto along = widened(Scalar(0));
  auto length = widened(Scalar(-1));
  for (int axis = 0; axis < 3; ++axis) {
    along = along + widened(line.point[axis]) * widened(line.direction[axis]);
    length = length + wide_square(line.direction[axis]);
  }
  Vector6<Scalar> result;
  for (int i = 0; i < 4; ++i)
    result[i] =
        squared_distance_error<Scalar>(spheres[i].center.cast<Scalar>(), line, spheres[i].square) / 2.0;
  result[4] = along.value();
  result[5] = length.value() / 2.0;
  return result;
}

/// Columns: point, direction.
template <class Scalar>
Matrix6<Scalar> jacobian(const FourSpheres& spheres, const Tangent<Scalar>& line) {
  Matrix6<Scalar> result;
  for (int i = 0; i < 4; ++i) {
    const Vector3<Scalar> w = spheres[i].center.cast<Scalar>() - line.point;
    const Scalar along = (w.transpose() * line.direction).value();
    result.row(i) << (along * line.direction - w).transpose(), -along * w.transpose();
  }
  result.row(4) << line.direction.transpose(), line.point.transpose();
  result.row(5) << Vector3<Scalar>::Zero().transpose(), line.direction.transpose();
  return result;
}

/// Smallest over largest pivot.
template <class Factors>
double pivot_ratio(const Factors& lu) {
  const Eigen::VectorXd pivots = lu.matrixLU().diagonal().cwiseAbs();
  return pivots.minCoeff() / pivots.maxCoeff();
}

/// The linear system of a Newton step in units of the line's size, so that lengths and directions compare:
/// rows of 1-norm 1, columns in units of the line's distance from the centres and of its direction's 2-norm,
/// which is above 1 for a complex one.
template <class Scalar>
struct NewtonSystem {
  Matrix6<Scalar> matrix;
  Vector6<Scalar> right;
  double distance = 1;
  double stretch = 1;
  Eigen::Matrix<double, 6, 1> row_sums = Eigen::Matrix<double, 6, 1>::Ones();  ///< by which rows are divided

  void subtract(const Vector6<Scalar>& change, Tangent<Scalar>& line) const {
    line.point -= distance * change.template head<3>();
    line.direction -= stretch * change.template tail<3>();
  }
};

template <class Scalar>
NewtonSystem<Scalar> newton_system(const FourSpheres& spheres, const Tangent<Scalar>& line) {
  NewtonSystem<Scalar> system{jacobian(spheres, line), residual(spheres, line), line.point.norm() + 1,
                              line.direction.norm()};
  system.matrix.template leftCols<3>() *= system.distance;
  system.matrix.template rightCols<3>() *= system.stretch;
  for (int i = 0; i < 6; ++i) {
    const double sum = system.matrix.row(i).cwiseAbs().sum();
    if (sum == 0) continue;  // at a distance of 0
    system.matrix.row(i) /= sum;
    system.right[i] /= sum;
    system.row_sums[i] = sum;
  }
  return system;
}

}  // namespace

template <class Scalar>
TangentRefinement refine(const FourSpheres& spheres, Tangent<Scalar>& line) {
  constexpr int most_iterations = 10;
  // Below the root of the rounding Newton's method can no longer tell a simple solution from a double one.
  constexpr double singular = 1e-7;
  // A simple solution's start is right to rounding times its condition: further away is another solution.
  constexpr double furthest = 1e-3;
  // A step that quadratic convergence would follow by one below the rounding, and what has settled. Rounding
  // keeps an ill-conditioned line from settling; towards a double one steps halve, which is no stalling.
  constexpr double last_step = 1e-9, settled = 1e-14;
  Tangent<Scalar> moved = line;
  TangentRefinement result;
  double way = 0;
  double previous = std::numeric_limits<double>::infinity();
  while (result.iterations < most_iterations) {
    const NewtonSystem<Scalar> system = newton_system(spheres, moved);
    const Eigen::PartialPivLU<Dense<Scalar>> lu(system.matrix);
    const Vector6<Scalar> step = lu.solve(system.right);
    const double length = step.norm();
    ++result.iterations;
    way += length;
    // Towards an isotropic direction, |u| growing, condition numbers grow with its third power.
    const double growth = std::pow(system.stretch, 3);
    if (!(growth * pivot_ratio(lu) >= singular) || !(way <= furthest)) return result;
    system.subtract(step, moved);
    const bool follows = length <= 1e-3 * previous, stalls = length > 0.7 * previous;
    result.is_regular =
        length <= settled || (length <= last_step && follows) || (length <= growth * last_step && stalls);
    if (result.is_regular) {
      line = moved;
      return result;
    }
    previous = length;
  }
  return result;
}

template <class Scalar>
void settle(const FourSpheres& spheres, Tangent<Scalar>& line) {
  // At a multiple solution found to rounding the vanishing singular values are below 1e-8.
  constexpr double vanishing = 1e-4;
  for (int i = 0; i < 2; ++i) {
    const NewtonSystem<Scalar> system = newton_system(spheres, line);
    system.subtract(shortest_solution(Dense<Scalar>(system.matrix), system.right, vanishing), line);
  }
}

std::array<Tangent<std::complex<double>>, 2> split(const FourSpheres& spheres,
                                                   const Tangent<std::complex<double>>& mean) {
  constexpr double step = 1e-3;  // the equations are of degree 4: a central difference is right to its square
  const NewtonSystem<std::complex<double>> system = newton_system(spheres, mean);
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(system.matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector6<std::complex<double>> v = svd.matrixV().col(5), w = svd.matrixU().col(5);
  const auto moved = [&](std::complex<double> s) {
    Tangent<std::complex<double>> line = mean;
    system.subtract(-s * v, line);
    return line;
  };
  const auto along_w = [&](const Tangent<std::complex<double>>& line) {
    return w.dot(residual(spheres, line).cwiseQuotient(system.row_sums.cast<std::complex<double>>()));
  };
  const std::complex<double> middle = along_w(mean);
  const std::complex<double> bend =
      (along_w(moved(step)) + along_w(moved(-step)) - 2.0 * middle) / (step * step);
  const std::complex<double> s = std::sqrt(-2.0 * middle / bend);
  return {moved(s), moved(-s)};
}

template <class Scalar>
double largest_excess(const FourSpheres& spheres, const Tangent<Scalar>& line) {
  double largest = 0;
  for (const Sphere& sphere : spheres)
    largest = std::max(
        largest, std::abs(squared_distance_error<Scalar>(sphere.center.cast<Scalar>(), line, sphere.square)));
  return largest;
}

template TangentRefinement refine(const FourSpheres&, Tangent<double>&);
template TangentRefinement refine(const FourSpheres&, Tangent<std::complex<double>>&);
template void settle(const FourSpheres&, Tangent<double>&);
template void settle(const FourSpheres&, Tangent<std::complex<double>>&);
template double largest_excess(const FourSpheres&, const Tangent<double>&);
template double largest_excess(const FourSpheres&, const Tangent<std::complex<double>>&);

}  // namespace gcs
