#include "solvers/figures/complex_distances.hpp"

#include <Eigen/LU>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/numeric/complex_double_double.hpp"

namespace gcs {

using Complex = std::complex<double>;

Eigen::VectorXcd ComplexDistances::value(const Eigen::VectorXcd& x) const {
  const Eigen::Matrix3Xd real = system_.figure(x.real()).points, imaginary = imaginary_points(x);
  Eigen::VectorXcd result(system_.equations());
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

Eigen::MatrixXcd ComplexDistances::jacobian(const Eigen::VectorXcd& x) const {
  Eigen::MatrixXd real(system_.equations(), system_.unknowns()), imaginary = real;
  system_.jacobian(system_.figure(x.real()).points, real);
  system_.jacobian(imaginary_points(x), imaginary);
  return real + Complex(0, 1) * imaginary;
}

Eigen::Matrix3Xd ComplexDistances::imaginary_points(const Eigen::VectorXcd& x) const {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, system_.point_count());
  system_.place(x.imag(), points);
  return points;
}

Figure complex_figure(const DistanceSystem& system, const Eigen::VectorXcd& x) {
  Figure figure = system.figure(x.real());
  figure.imaginary = Eigen::Matrix3Xd::Zero(3, system.point_count());
  system.place(x.imag(), figure.imaginary);
  for (std::size_t i = 0; i < figure.lines.size(); ++i)
    figure.imaginary_lines.push_back({Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  return figure;
}

Figure polished(const Scene& scene, const std::vector<DoubleDouble>& squares, const Figure& figure) {
  constexpr int most_steps = 3, most_unknowns = 300;
  const DistanceSystem system(scene);
  if (system.unknowns() > most_unknowns) return figure;
  const ComplexDistances equations(system, squares);
  Eigen::VectorXcd x(system.unknowns());
  x.real() = system.coordinates({figure.points, {}, {}});
  x.imag() = system.coordinates({figure.imaginary, {}, {}});
  Figure best = figure;
  double residual = relative_residual(scene, best);
  for (int step = 0; step < most_steps; ++step) {
    x -= equations.jacobian(x).lu().solve(equations.value(x));
    Figure next = complex_figure(system, x);
    const double left = relative_residual(scene, next);
    if (!(left < residual)) break;
    residual = left;
    best = std::move(next);
  }
  return best;
}

}  // namespace gcs
