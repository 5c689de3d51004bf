#include "solvers/figures/general_figures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/figures/singular_ratio.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// In the scene's unit, in which lengths are near 1: what residuals are relative to where terms are smaller still, as
/// they are in f·u = 0 of a line through the origin.
constexpr double smallest_size = 1e-3;

double size_of(const ComplexValues& x) {
  double size = 1;
  for (const std::complex<double>& value : x) size = std::max(size, std::abs(value));
  return size;
}

/// The errors of two figures, and the rounding of coordinates.
double reach_of(const GeneralTolerance& tolerance, double size) {
  return std::min(tolerance.relative * size, std::max(64 * unit_roundoff * size, 4 * tolerance.error));
}

}  // namespace

double GeneralJudge::residual(const Figure& figure) const {
  const EquationResiduals here = equations_.residuals(system_.coordinates(figure));
  double worst = system_.misfit(figure) / system_.elements().scene().size();
  if (!std::isfinite(worst)) return infinity;
  for (Eigen::Index e = 0; e < here.value.size(); ++e) {
    const double error = std::abs(here.value[e]) / std::max(here.size[e], smallest_size);
    if (!std::isfinite(error)) return infinity;
    worst = std::max(worst, error);
  }
  return worst;
}

Eigen::MatrixXcd GeneralJudge::jacobian(const Figure& figure) const {
  Eigen::MatrixXcd matrix = equations_.jacobian(system_.coordinates(figure));
  for (auto row : matrix.rowwise()) {
    const double norm = row.norm();
    if (!(norm > 0)) continue;
    row.real() /= norm;
    row.imag() /= norm;
  }
  return matrix;
}

double GeneralJudge::condition(const Figure& figure) const {
  const Eigen::MatrixXcd matrix = jacobian(figure);
  if (!matrix.allFinite()) return infinity;
  return is_real(matrix) ? rounded_singular_ratio(Eigen::MatrixXd(matrix.real()))
                         : rounded_singular_ratio(matrix);
}

bool is_real(const Eigen::MatrixXcd& matrix) { return (matrix.imag().array() == 0).all(); }

ReflectionClasses general_classes(const Scene& scene, std::span<const Figure> figures,
                                  std::span<const GeneralTolerance> tolerances) {
  ReflectionClasses classes;
  const bool has_system = !why_no_system(scene);
  std::vector<ComplexValues> known;  // of the first of each class
  const auto equal = [&](const SignMasks& signs, const ComplexValues& x, const ComplexValues& y,
                         const GeneralTolerance& a, const GeneralTolerance& b) {
    const double size = std::max(size_of(x), size_of(y));
    const double reach = std::max(reach_of(a, size), reach_of(b, size));
    return some_signs_fit(signs,
                          [&](std::size_t i, double sign) { return std::abs(x[i] - sign * y[i]) <= reach; });
  };
  if (!has_system) {
    for (std::size_t i = 0; i < figures.size(); ++i) {
      classes.class_of.push_back(static_cast<int>(i));
      classes.first.push_back(static_cast<int>(i));
    }
    return classes;
  }
  const SceneSystem system(scene);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const ComplexValues x = system.coordinates(figures[i]);
    int number = 0;
    for (; number < classes.count(); ++number) {
      const auto first = static_cast<std::size_t>(classes.first[static_cast<std::size_t>(number)]);
      if (figures[first].is_real() == figures[i].is_real() &&
          equal(system.equations().mirror, x, known[static_cast<std::size_t>(number)], tolerances[first],
                tolerances[i]))
        break;
    }
    if (number == classes.count()) {
      classes.first.push_back(static_cast<int>(i));
      known.push_back(x);
    }
    classes.class_of.push_back(number);
  }
  return classes;
}

}  // namespace gcs
