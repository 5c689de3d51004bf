#include "solvers/answers/settled_figure.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "solvers/elements/dense_equations.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

constexpr slong bits = 128;

Eigen::VectorXcd midpoints(const BallMatrix& column) {
  Eigen::VectorXcd result(column.rows());
  for (slong i = 0; i < column.rows(); ++i) result[i] = rounded_midpoint(column(i, 0));
  return result;
}

}  // namespace

FigureSettler::FigureSettler(const Scene& scene) : system_(scene), equations_(system_.equations(), bits) {}

Figure FigureSettler::settled(const Figure& figure) const {
  constexpr int most_steps = 4;
  constexpr double roundings = 1000;  // of residuals in doubles
  const auto n = static_cast<Eigen::Index>(equations_.unknowns());
  if (std::ssize(system_.equations().equations) != n) return figure;
  ComplexValues x = system_.coordinates(figure);
  Eigen::Map<Eigen::VectorXcd> at(x.data(), n);
  const Eigen::PartialPivLU<Eigen::MatrixXcd> factors(jacobian_at(system_.equations(), x));
  const double size = 1 + at.cwiseAbs().maxCoeff();
  double last = std::min(1e-6, roundings * epsilon / factors.rcond()) * size;
  for (int step = 0; step < most_steps && last > epsilon * size; ++step) {
    const Eigen::VectorXcd change = factors.solve(midpoints(equations_.value(BallKrawczyk::vector(x))));
    const double length = change.cwiseAbs().maxCoeff();
    if (!(length <= last)) return step == 0 ? figure : system_.figure(x, figure.is_real());
    at -= change;
    last = length / 2;
  }
  return system_.figure(x, figure.is_real());
}

}  // namespace gcs
