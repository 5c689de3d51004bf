#include "solvers/certification/krawczyk.hpp"

#include <Eigen/LU>
#include <limits>

namespace gcs {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// f(mid), each with a bound on its error: squares in double-double are right to `epsilon`² relative to their
/// terms, and the sum is rounded once.
struct Residual {
  Eigen::VectorXd value;
  Eigen::VectorXd error;
};

Residual residual(const DistanceSystem& system, const std::vector<DoubleDouble>& squares,
                  const Eigen::Matrix3Xd& points) {
  Residual result{Eigen::VectorXd(system.equations()), Eigen::VectorXd(system.equations())};
  for (int e = 0; e < system.equations(); ++e) {
    const DoubleDouble square = system.squared_length(points, e);
    result.value[e] = (square - squares[e]).value() / 2;
    result.error[e] = epsilon * std::abs(result.value[e]) +
                      64 * epsilon * epsilon * (std::abs(square.hi) + std::abs(squares[e].hi));
  }
  return result;
}

/// How far the entries of the Jacobian, which are differences of coordinates, move within the box.
Eigen::MatrixXd jacobian_radius(const DistanceSystem& system, const Box& box) {
  Eigen::MatrixXd radius = Eigen::MatrixXd::Zero(system.equations(), system.unknowns());
  const auto radius_of = [&](int unknown) { return unknown >= 0 ? box.radius[unknown] : 0.0; };
  for (int e = 0; e < system.equations(); ++e) {
    const auto [a, b] = system.edges()[e];
    // The foot on the line, the x-axis, moves along with the point.
    for (int axis = system.is_line(b) ? 1 : 0; axis < system.dimension(); ++axis) {
      const int i = system.unknown(a, axis);
      const int j = system.unknown(b, axis);
      const double sum = radius_of(i) + radius_of(j);
      if (i >= 0) radius(e, i) = sum;
      if (j >= 0) radius(e, j) = sum;
    }
  }
  return radius;
}

}  // namespace

BoxContent krawczyk(const DistanceSystem& system, const std::vector<DoubleDouble>& squares, const Box& box) {
  const int m = system.unknowns();
  const Eigen::Matrix3Xd points = system.figure(box.mid).points;
  Eigen::MatrixXd jacobian(m, m);
  system.jacobian(points, jacobian);
  const Eigen::MatrixXd inverse = jacobian.partialPivLu().inverse();
  if (!inverse.allFinite()) return BoxContent::unknown;

  const Residual f = residual(system, squares, points);
  const Eigen::MatrixXd size = inverse.cwiseAbs();
  const double rounding = 2 * (m + 2) * epsilon;  // of a scalar product of length m, relative to its terms
  const Eigen::VectorXd move = inverse * f.value;
  const Eigen::MatrixXd defect =
      (Eigen::MatrixXd::Identity(m, m) - inverse * jacobian).cwiseAbs() +
      size * (rounding * jacobian.cwiseAbs() + (1 + rounding) * jacobian_radius(system, box)) +
      epsilon * Eigen::MatrixXd::Identity(m, m);
  const Eigen::VectorXd spread =
      (1 + rounding) * (defect * box.radius + size * (f.error + rounding * f.value.cwiseAbs()));

  if (((spread + move.cwiseAbs()) * (1 + rounding) - box.radius).maxCoeff() < 0)
    return BoxContent::one_solution;
  if ((move.cwiseAbs() - (spread + box.radius) * (1 + rounding)).maxCoeff() > 0)
    return BoxContent::no_solution;
  return BoxContent::unknown;
}

}  // namespace gcs
