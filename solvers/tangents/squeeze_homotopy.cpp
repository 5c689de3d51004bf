#include "solvers/tangents/squeeze_homotopy.hpp"

#include <Eigen/LU>

namespace gcs {
namespace {

using Complex = std::complex<double>;

ComplexSpheres halfway(const ComplexSpheres& a, const ComplexSpheres& b) {
  return {(a.centers + b.centers) / 2, (a.squares + b.squares) / 2, (a.first_square + b.first_square) / 2.0};
}

using Products = Eigen::Matrix<Complex, 6, 1>;

/// x², xp, xm, p², pm, m² of u = (x, p, m).
Products products_of(const Eigen::Vector3cd& u) {
  return Products{{u[0] * u[0], u[0] * u[1], u[0] * u[2], u[1] * u[1], u[1] * u[2], u[2] * u[2]}};
}

Eigen::Matrix<Complex, 6, 3> derivatives_of_products(const Eigen::Vector3cd& u) {
  Eigen::Matrix<Complex, 6, 3> result;
  result << 2.0 * u[0], 0, 0, u[1], u[0], 0, u[2], 0, u[0], 0, 2.0 * u[1], 0, 0, u[2], u[1], 0, 0, 2.0 * u[2];
  return result;
}

}  // namespace

ComplexSpheres ComplexSpheres::turned(double b) const {
  ComplexSpheres result = *this;
  for (int i = 0; i < 3; ++i) result.centers.col(i) = turned_by(b, centers.col(i));
  return result;
}

SqueezeHomotopy::SqueezeHomotopy(const ComplexSpheres& from, const ComplexSpheres& to,
                                 const ScaledLine& at_start)
    : equations_{equations_of(from), equations_of(halfway(from, to)), equations_of(to)},
      square_from_(from.first_square),
      square_change_(to.first_square - from.first_square),
      patch_(at_start.direction.adjoint() / at_start.direction.squaredNorm()) {
  const Eigen::FullPivLU<Eigen::MatrixXcd> lu(equations_[2]);
  Eigen::Matrix3cd pivots;
  for (int i = 0; i < 3; ++i) pivots.col(i) = equations_[2].col(lu.permutationQ().indices()[i]);
  const Eigen::Matrix3cd combine = pivots.inverse();
  for (Equations& equations : equations_) equations = combine * equations;
}

SqueezeHomotopy::Equations SqueezeHomotopy::equations_of(const ComplexSpheres& spheres) {
  Equations result;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3cd c = spheres.centers.col(i);
    const Complex across = c[1] * c[2], constant = across + (spheres.first_square - spheres.squares[i]);
    result.row(i) << c[0], c[2] / 2.0, c[1] / 2.0, -constant / 2.0, c[0] * c[2] / 2.0, c[0] * c[1] / 2.0,
        c[2] * c[2] / 8.0, (across / 2.0 - constant - c[0] * c[0]) / 2.0, c[1] * c[1] / 8.0;
  }
  return result;
}

HomotopyValue<6> SqueezeHomotopy::at(const Vector& x, Complex t) const {
  const Eigen::Vector3cd u = x.head<3>(), p = x.tail<3>();
  // Lagrange's interpolation at 0, 1/2 and 1.
  const Equations equations = (2.0 * t - 1.0) * (t - 1.0) * equations_[0] +
                              4.0 * t * (1.0 - t) * equations_[1] + t * (2.0 * t - 1.0) * equations_[2];
  const Equations change =
      (4.0 * t - 3.0) * equations_[0] + (4.0 - 8.0 * t) * equations_[1] + (4.0 * t - 1.0) * equations_[2];
  const Products products = products_of(u);
  const Eigen::RowVector3cd of_u = isotropic_dual(u), of_p = isotropic_dual(p);
  const Complex uu = isotropic_product(u, u), square = square_from_ + t * square_change_;
  HomotopyValue<6> result;
  result.value << equations.leftCols<3>() * p + equations.rightCols<6>() * products, (of_p * u).value(),
      (of_p * p).value() - square * uu * uu, (patch_ * u).value() - 1.0;
  result.jacobian.setZero();
  result.jacobian.topLeftCorner<3, 3>() = equations.rightCols<6>() * derivatives_of_products(u);
  result.jacobian.topRightCorner<3, 3>() = equations.leftCols<3>();
  result.jacobian.row(3) << of_p, of_u;
  result.jacobian.row(4) << -4.0 * square * uu * of_u, 2.0 * of_p;
  result.jacobian.row(5).head<3>() = patch_;
  result.t_derivative << change.leftCols<3>() * p + change.rightCols<6>() * products, 0,
      -square_change_ * uu * uu, 0;
  return result;
}

}  // namespace gcs
