#include "solvers/answers/settled_figure.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "solvers/numeric/rounding.hpp"

namespace gcs {

FigureSettler::FigureSettler(const SceneSystem& system) : system_(system), equations_(system.equations()) {}

Figure FigureSettler::settled(const Figure& figure, double condition) const {
  constexpr int most_steps = 4;
  constexpr double roundings = 1000;  // of residuals in doubles
  if (std::ssize(equations_.equations) != equations_.unknowns) return figure;
  const ComplexValues x = system_.coordinates(figure);
  Eigen::VectorXcd at = Eigen::Map<const Eigen::VectorXcd>(x.data(), equations_.unknowns);
  LinearisedSystem<std::complex<double>> f = linearised(equations_, at);
  const Eigen::PartialPivLU<Eigen::MatrixXcd> factors(f.jacobian);
  const double size = 1 + at.cwiseAbs().maxCoeff();
  double last = std::min(1e-6, roundings * epsilon * condition) * size;
  for (int step = 0; step < most_steps && last > epsilon * size; ++step) {
    if (step > 0) f = linearised(equations_, at);
    const Eigen::VectorXcd change = factors.solve(f.value);
    const double length = change.cwiseAbs().maxCoeff();
    if (!(length <= last))
      return step == 0 ? figure : system_.figure({at.begin(), at.end()}, figure.is_real());
    at -= change;
    last = length / 2;
  }
  return system_.figure({at.begin(), at.end()}, figure.is_real());
}

}  // namespace gcs
