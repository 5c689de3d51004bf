#include "solvers/certificates/scene_equations.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/elements/given_elements.hpp"
#include "solvers/model/complex_lines.hpp"
#include "solvers/model/distance_equations.hpp"
#include "solvers/model/given_numbers.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// Of the six unknowns of a free line.
enum LinePart { point = 0, direction = 1 };

/// Changing the sign of a line's direction gives the same line.
constexpr SignMask first_line_mirror = SignMask{1} << 3;

bool is_free_beside_given_points(const Scene& scene) { return scene.has_lines() && scene.is_anchored(); }

/// How far the line that the frame puts on the x-axis is from there, its direction times `size`.
double offset_from_axis(const Figure& figure, double size) {
  const LinePosition& line = figure.lines.front();
  const Eigen::Vector3d turn = line.direction.cwiseAbs() - Eigen::Vector3d::UnitX();
  Eigen::Vector3d point = line.point, height = Eigen::Vector3d::Zero(), turned = height;
  if (!figure.is_real()) {
    height = figure.imaginary_lines.front().point;
    turned = figure.imaginary_lines.front().direction;
  }
  return std::max(std::hypot(point.norm(), height.norm()), size * std::hypot(turn.norm(), turned.norm()));
}

ScaledUnknown times(const ExactNumber& coefficient, int unknown) { return {unknown, coefficient}; }
ScaledUnknown minus(int unknown) { return {unknown, exactly(-1)}; }

}  // namespace

std::optional<std::string> why_not_certified(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  if (has_element_equations(problem)) {
    if (auto reason = why_no_system(scene)) return reason;
    const QuadraticSystem system = SceneSystem(scene).equations();
    if (static_cast<int>(system.equations.size()) != system.unknowns)
      return "the scene has not as many equations as unknowns";
    return std::nullopt;
  }
  if (scene.has_lines() && !scene.is_anchored() && (problem.lines.size() > 1 || scene.reference().line < 0))
    return "certificates know one line at most, which the frame puts on the x-axis";
  const auto points = static_cast<int>(problem.points.size());
  for (int point = 0; scene.has_lines() && scene.is_anchored() && point < points; ++point)
    if (!problem.is_fixed(point))
      return "beside a line certificates know given points, or free ones, not both";
  return std::nullopt;
}

SceneEquations::SceneEquations(const Scene& scene) : scene_(scene), points_(scene) {
  if (has_element_equations(scene.problem())) {
    general_.emplace(scene);
    return;
  }
  const ProblemStatement& problem = scene.problem();
  system_.mirror = mirror_axes(scene, points_);
  const bool has_free_lines = is_free_beside_given_points(scene);
  for (int i = 0; i < scene.constraint_count(); ++i) {
    const bool is_beside_free_line = has_free_lines && points_.is_line(points_.edges()[i][1]);
    system_.equations.push_back(is_beside_free_line ? distance_to_free_line(i)
                                                    : distance_equation(scene, points_, i));
  }
  for (int line = 0; has_free_lines && line < static_cast<int>(problem.lines.size()); ++line)
    add_line_conditions(line);
  system_.unknowns = static_cast<int>(system_.mirror.size());
}

QuadraticSystem SceneEquations::system_at(const std::vector<std::complex<double>>& squares) const {
  QuadraticSystem result = system();
  std::size_t next = 0;
  for (std::size_t e = 0; e < result.equations.size() && next < squares.size(); ++e)
    if (!general_ || general_->value_of()[e] != no_value)
      result.equations[e].given = exactly(squares[next++]);
  return result;
}

int SceneEquations::line_unknown(int line, int part, int axis) const {
  if (!is_free_beside_given_points(scene_)) return -1;
  return points_.unknowns() + 6 * line + 3 * part + axis;
}

/// |c − p|² + |c × u|² − c·c = a²
QuadraticEquation SceneEquations::distance_to_free_line(int constraint) const {
  const auto [c, entity] = points_.edges()[static_cast<std::size_t>(constraint)];
  const int line = entity - points_.point_count();
  QuadraticEquation equation{{}, given_square(scene_, constraint)};
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    const ExactNumber here = given_coordinate(scene_, c, axis);
    const LinearForm apart{{minus(line_unknown(line, point, axis))}, here};
    const LinearForm across{
        {times(given_coordinate(scene_, c, next), line_unknown(line, direction, last)),
         times(negated(given_coordinate(scene_, c, last)), line_unknown(line, direction, next))},
        {}};
    equation.products.push_back({apart, apart});
    equation.products.push_back({across, across});
    equation.products.push_back({{{}, here}, {{}, negated(here)}});
  }
  return equation;
}

/// u·u = 1 and u·p = 0.
void SceneEquations::add_line_conditions(int line) {
  const auto unknown = [&](int part, int axis) { return LinearForm{{{line_unknown(line, part, axis)}}, {}}; };
  QuadraticEquation unit{{}, exactly(1)}, orthogonal;
  for (int axis = 0; axis < 3; ++axis) {
    unit.products.push_back({unknown(direction, axis), unknown(direction, axis)});
    orthogonal.products.push_back({unknown(direction, axis), unknown(point, axis)});
  }
  system_.equations.push_back(std::move(unit));
  system_.equations.push_back(std::move(orthogonal));
  for (const int part : {point, direction})
    for (int axis = 0; axis < 3; ++axis)
      system_.mirror.push_back(part == point ? 0 : first_line_mirror << line);
}

std::vector<std::complex<double>> SceneEquations::coordinates(const Figure& figure) const {
  if (general_) return general_->coordinates(figure);
  const Eigen::VectorXd real = points_.coordinates(figure);
  Eigen::VectorXd imaginary = Eigen::VectorXd::Zero(real.size());
  if (!figure.is_real()) imaginary = points_.coordinates({figure.imaginary, {}});
  std::vector<std::complex<double>> x;
  for (Eigen::Index i = 0; i < real.size(); ++i) x.emplace_back(real[i], imaginary[i]);
  if (!is_free_beside_given_points(scene_)) return x;
  for (const ComplexLine& line : complex_lines(figure))
    for (const Eigen::Vector3cd& part : {line.point, line.direction})
      x.insert(x.end(), part.begin(), part.end());
  return x;
}

double SceneEquations::offset_from_given(const Figure& figure, int point, int axis) const {
  const double given = points_.given_coordinate(point, axis);
  const double height = figure.is_real() ? 0 : figure.imaginary(axis, point);
  // The given coordinate is the nearest double of a decimal.
  return std::hypot(figure.points(axis, point) - given, height) + epsilon * std::abs(given);
}

double SceneEquations::general_distance(const Figure& figure, const Certificate& certificate) const {
  const ComplexValues x = coordinates(figure);
  std::vector<double> offsets;
  for (std::size_t i = 0; i < x.size(); ++i) offsets.push_back(certificate.offset(i, x[i]));
  return general_->distance(figure, x, offsets);
}

double SceneEquations::distance(const Figure& figure, const Certificate& certificate) const {
  if (general_) return general_distance(figure, certificate);
  const std::vector<std::complex<double>> x = coordinates(figure);
  const auto offset = [&](int unknown) {
    const auto i = static_cast<std::size_t>(unknown);
    return certificate.offset(i, x[i]);
  };
  double largest = 0;
  for (int point = 0; point < points_.point_count(); ++point) {
    double square = 0;
    for (int axis = 0; axis < points_.dimension(); ++axis) {
      const int unknown = points_.unknown(point, axis);
      const double part = unknown >= 0 ? offset(unknown) : offset_from_given(figure, point, axis);
      square += part * part;
    }
    largest = std::max(largest, std::sqrt(square));
  }
  if (scene_.has_lines() && !scene_.is_anchored())
    largest = std::max(largest, offset_from_axis(figure, scene_.size()));
  for (std::size_t line = 0; is_free_beside_given_points(scene_) && line < figure.lines.size(); ++line)
    for (const int part : {point, direction}) {
      double square = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double along = offset(line_unknown(static_cast<int>(line), part, axis));
        square += along * along;
      }
      largest = std::max(largest, std::sqrt(square) * (part == direction ? scene_.size() : 1));
    }
  return largest * (1 + 16 * epsilon);
}

}  // namespace gcs
