#include "solvers/figures/residual_and_condition.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "solvers/figures/general_figures.hpp"
#include "solvers/figures/point_conditions.hpp"
#include "solvers/figures/singular_ratio.hpp"
#include "solvers/figures/sparse_condition.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/line_jacobian.hpp"

namespace gcs {
namespace {

using Vector = std::array<DoubleDouble, 3>;

Vector difference(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return {two_sum(a[0], -b[0]), two_sum(a[1], -b[1]), two_sum(a[2], -b[2])};
}

DoubleDouble squared_norm(const Vector& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

/// |(p − q) × u| / |u|
double distance_to_line(const Eigen::Vector3d& point, const LinePosition& line) {
  const Vector w = difference(point, line.point);
  const Vector u = difference(line.direction, Eigen::Vector3d::Zero());
  const Vector cross{w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]};
  return sqrt(squared_norm(cross)).value() / sqrt(squared_norm(u)).value();
}

double distance(const ProblemStatement& problem, const Figure& figure, std::array<int, 2> between) {
  if (!problem.is_point(between[0])) std::swap(between[0], between[1]);
  const Eigen::Vector3d first = figure.points.col(between[0]);
  if (!problem.is_point(between[1]))
    return distance_to_line(first, figure.lines[between[1] - problem.points.size()]);
  return sqrt(squared_distance(first, Eigen::Vector3d(figure.points.col(between[1])), 3)).value();
}

Eigen::Vector3cd complex_point(const Figure& figure, int point) {
  Eigen::Vector3cd position = figure.points.col(point).cast<std::complex<double>>();
  position.imag() = figure.imaginary.col(point);
  return position;
}

/// d² − length² of a complex figure.
std::complex<double> complex_excess(const ProblemStatement& problem, const Figure& figure,
                                    std::array<int, 2> between, double length) {
  if (!problem.is_point(between[0])) std::swap(between[0], between[1]);
  const Eigen::Vector3cd first = complex_point(figure, between[0]);
  const DoubleDouble square = two_product(length, length);
  if (problem.is_point(between[1]))
    return squared_distance_excess(first, complex_point(figure, between[1]), square);
  return squared_distance_excess(first, complex_lines(figure)[between[1] - problem.points.size()], square);
}

/// What residuals are relative to where lengths are shorter still.
double shortest_length(const Scene& scene) { return 1e-3 * scene.size(); }

/// |d − length| of a constraint. Of a complex figure only d² is a function of the coordinates: with d the
/// root of positive real part, |d² − length²| / |d + length|, where the sum is not below shortest_length.
double error_of(const Scene& scene, const Figure& figure, int constraint) {
  const auto [a, b] = scene.problem().constraints[constraint].between;
  const double length = scene.target_lengths()[constraint];
  if (figure.is_real()) return std::abs(distance(scene.problem(), figure, {a, b}) - length);
  const std::complex<double> excess = complex_excess(scene.problem(), figure, {a, b}, length);
  const std::complex<double> sum = std::sqrt(excess + length * length) + length;
  return std::abs(excess) / std::max(std::abs(sum), shortest_length(scene));
}

/// Where a point lies on a line its row vanishes, and what rounding leaves of it is no direction.
Eigen::MatrixXcd normalised_line_jacobian(const Scene& scene, const Figure& figure) {
  Eigen::MatrixXcd jacobian = line_jacobian(scene, figure);
  for (Eigen::Index row = 0; row < jacobian.rows(); ++row) {
    const bool vanishes = row < scene.constraint_count() && scene.target_lengths()[row] == 0;
    jacobian.row(row) /= vanishes ? scene.size() : jacobian.row(row).norm();
  }
  return jacobian;
}

/// Of a real figure, its rows normalised.
Eigen::MatrixXd real_jacobian(const DistanceSystem& system, const Figure& figure) {
  Eigen::MatrixXd jacobian(system.equations(), system.unknowns());
  system.jacobian(figure.points, jacobian);
  jacobian.rowwise().normalize();
  return jacobian;
}

/// Likewise of a complex one.
Eigen::MatrixXcd complex_jacobian(const DistanceSystem& system, const Figure& figure) {
  Eigen::MatrixXd part(system.equations(), system.unknowns());
  system.jacobian(figure.points, part);
  Eigen::MatrixXcd jacobian = part.cast<std::complex<double>>();
  system.jacobian(figure.imaginary, part);
  jacobian.imag() = part;
  jacobian.rowwise().normalize();
  return jacobian;
}

/// Whether a condition number is at least stiff_condition by its estimate from a factorisation, to be on the
/// safe side: the 2-norm's is up to `size` times the 1-norm's, and that of the estimate rarely a tenth too
/// small.
template <class Matrix>
bool is_perhaps_stiff(const Matrix& matrix) {
  constexpr double doubt = 10;
  const double reciprocal = matrix.partialPivLu().rcond();
  return !(reciprocal * stiff_condition >= doubt * static_cast<double>(matrix.rows()));
}

double residual_of_distances(const Scene& scene, const Figure& figure) {
  double worst = 0;
  for (int i = 0; i < scene.constraint_count(); ++i) {
    const double length = scene.target_lengths()[i];
    const double error = error_of(scene, figure, i);
    if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
    worst = std::max(worst, error / std::max(length, shortest_length(scene)));
  }
  return worst;
}

double condition_of_distances(const Scene& scene, const Figure& figure) {
  if (scene.has_lines()) return singular_ratio(normalised_line_jacobian(scene, figure));
  const Figure* const one = &figure;
  if (const auto points = PointConditions::of(scene)) return points->conditions({&one, 1}).front();
  return sparse_jacobian_condition(scene, figure);
}

}  // namespace

FigureJudge::FigureJudge(const Scene& scene) : scene_(scene) {
  if (!scene.problem().is_general() || why_no_system(scene)) return;
  system_ = std::make_shared<const SceneSystem>(scene);
  general_ = std::make_shared<const GeneralJudge>(*system_);
}

FigureJudge::FigureJudge(const SceneSystem& system) : scene_(system.elements().scene()) {
  if (scene_.problem().is_general()) general_ = std::make_shared<const GeneralJudge>(system);
}

const SceneSystem* FigureJudge::system() const { return general_ ? &general_->system() : nullptr; }

double FigureJudge::residual(const Figure& figure) const {
  if (general_) return general_->residual(figure);
  return scene_.problem().is_general() ? std::numeric_limits<double>::infinity()
                                       : residual_of_distances(scene_, figure);
}

double FigureJudge::condition(const Figure& figure) const {
  if (general_) return general_->condition(figure);
  return scene_.problem().is_general() ? std::numeric_limits<double>::infinity()
                                       : condition_of_distances(scene_, figure);
}

bool FigureJudge::may_be_stiff(const Figure& figure) const {
  if (general_) {
    const Eigen::MatrixXcd jacobian = general_->jacobian(figure);
    return is_real(jacobian) ? is_perhaps_stiff(Eigen::MatrixXd(jacobian.real()))
                             : is_perhaps_stiff(jacobian);
  }
  if (scene_.problem().is_general() || scene_.has_lines()) return true;
  const DistanceSystem system(scene_);
  if (system.unknowns() > most_dense_unknowns) return true;
  return figure.is_real() ? is_perhaps_stiff(real_jacobian(system, figure))
                          : is_perhaps_stiff(complex_jacobian(system, figure));
}

bool FigureJudge::is_stiff(const Figure& figure) const {
  return may_be_stiff(figure) && condition(figure) >= stiff_condition;
}

double relative_residual(const Scene& scene, const Figure& figure) {
  return FigureJudge(scene).residual(figure);
}

double jacobian_condition(const Scene& scene, const Figure& figure) {
  return FigureJudge(scene).condition(figure);
}

double extent(const Figure& figure) {
  const double points = complex_points(figure).lpNorm<Eigen::Infinity>();
  double result = points;
  for (const ComplexLine& line : complex_lines(figure))
    result = std::max(result, (points + line.point.cwiseAbs().maxCoeff()) * line.direction.norm());
  return result;
}

bool loses_distances(const Scene& scene, const Figure& figure) {
  return extent(figure) > 0x1p26 * scene.size();
}

bool is_stiff(const Scene& scene, const Figure& figure) { return FigureJudge(scene).is_stiff(figure); }

}  // namespace gcs
