#include "solvers/certification/krawczyk.hpp"

#include <Eigen/LU>
#include <limits>

#include "solvers/certification/krawczyk_image.hpp"

namespace gcs {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// f(mid), each with a bound on its error: squares in double-double are right to `epsilon`² relative to their
/// terms, and the sum is rounded once.
LinearisedSystem<double> linearised(const DistanceSystem& system, const std::vector<DoubleDouble>& squares,
                                    const Eigen::Matrix3Xd& points) {
  const int m = system.unknowns();
  LinearisedSystem<double> f{Eigen::VectorXd(m), Eigen::VectorXd(m), Eigen::MatrixXd(m, m)};
  for (int e = 0; e < system.equations(); ++e) {
    const DoubleDouble square = system.squared_length(points, e);
    f.value[e] = (square - squares[e]).value() / 2;
    f.value_error[e] = epsilon * std::abs(f.value[e]) +
                       64 * epsilon * epsilon * (std::abs(square.hi) + std::abs(squares[e].hi));
  }
  system.jacobian(points, f.jacobian);
  return f;
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
  const LinearisedSystem<double> f = linearised(system, squares, system.figure(box.mid).points);
  const Eigen::MatrixXd inverse = f.jacobian.partialPivLu().inverse();
  if (!inverse.allFinite()) return BoxContent::unknown;
  const KrawczykImage<double> image = krawczyk_image(inverse, f, jacobian_radius(system, box), box.radius);
  if ((image.reach().array() < box.radius.array()).all()) return BoxContent::one_solution;
  if ((image.move.cwiseAbs().array() > (image.spread + box.radius).array() * (1 + 4 * epsilon)).any())
    return BoxContent::no_solution;
  return BoxContent::unknown;
}

}  // namespace gcs
