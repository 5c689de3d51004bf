#include "solvers/figures/sparse_condition.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <cmath>
#include <complex>
#include <limits>
#include <random>
#include <vector>

#include "solvers/model/complex_points.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {
namespace {

template <class Scalar>
using Column = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
template <class Scalar>
using Positions = Eigen::Matrix<Scalar, 3, Eigen::Dynamic>;

/// Rows of norm 1.
template <class Scalar>
Eigen::SparseMatrix<Scalar> jacobian(const DistanceSystem& system, const Positions<Scalar>& points) {
  std::vector<Eigen::Triplet<Scalar>> entries;
  for (int row = 0; row < system.equations(); ++row) {
    const auto& [a, b] = system.edges()[row];
    const Eigen::Matrix<Scalar, 3, 1> difference = points.col(a) - points.col(b);
    const std::size_t first = entries.size();
    double square = 0;
    for (int axis = 0; axis < system.dimension(); ++axis)
      for (const auto& [entity, sign] : {std::pair{a, 1.0}, std::pair{b, -1.0}}) {
        const int column = system.unknown(entity, axis);
        if (column < 0) continue;
        entries.emplace_back(row, column, sign * difference[axis]);
        square += std::norm(difference[axis]);
      }
    for (std::size_t i = first; i < entries.size(); ++i)
      entries[i] = {row, entries[i].col(), entries[i].value() / std::sqrt(square)};
  }
  Eigen::SparseMatrix<Scalar> matrix(system.equations(), system.unknowns());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// The square root of the largest eigenvalue of a Hermitian positive operator, from below.
template <class Scalar, class Operator>
double largest_singular_value(Eigen::Index size, const Operator& apply) {
  constexpr int steps = 40;
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Column<Scalar> x = Column<Scalar>::NullaryExpr(size, [&] { return Scalar(uniform(random)); }).normalized();
  double eigenvalue = 0;
  for (int step = 0; step < steps; ++step) {
    x = apply(x);
    eigenvalue = x.norm();
    x /= eigenvalue;
  }
  return std::sqrt(eigenvalue);
}

template <class Scalar>
double condition_of(const Eigen::SparseMatrix<Scalar>& matrix) {
  Eigen::SparseLU<Eigen::SparseMatrix<Scalar>> factors;
  factors.compute(matrix);
  if (factors.info() != Eigen::Success) return std::numeric_limits<double>::infinity();
  const double largest = largest_singular_value<Scalar>(matrix.cols(), [&](const Column<Scalar>& x) {
    return Column<Scalar>(matrix.adjoint() * Column<Scalar>(matrix * x));
  });
  const double inverse_of_smallest =
      largest_singular_value<Scalar>(matrix.cols(), [&](const Column<Scalar>& x) {
        return Column<Scalar>(factors.solve(Column<Scalar>(factors.adjoint().solve(x))));
      });
  const double condition = largest * inverse_of_smallest;
  return std::isfinite(condition) ? condition : std::numeric_limits<double>::infinity();
}

}  // namespace

double sparse_jacobian_condition(const Scene& scene, const Figure& figure) {
  const DistanceSystem system(scene);
  if (figure.is_real()) return condition_of(jacobian<double>(system, figure.points));
  return condition_of(jacobian<std::complex<double>>(system, complex_points(figure)));
}

}  // namespace gcs
