#include "solvers/problem/problem_statement.hpp"

#include <algorithm>
#include <utility>

namespace gcs {

Figure::Figure() = default;
Figure::Figure(const Figure&) = default;
Figure::Figure(Figure&&) noexcept = default;
Figure& Figure::operator=(const Figure&) = default;
Figure& Figure::operator=(Figure&&) noexcept = default;
Figure::~Figure() = default;

Figure::Figure(Eigen::Matrix3Xd of_points, std::vector<LinePosition> of_lines,
               Eigen::Matrix3Xd imaginary_points, std::vector<LinePosition> of_imaginary_lines,
               std::vector<PlanePosition> of_planes, std::vector<PlanePosition> of_imaginary_planes)
    : points(std::move(of_points)),
      lines(std::move(of_lines)),
      imaginary(std::move(imaginary_points)),
      imaginary_lines(std::move(of_imaginary_lines)),
      planes(std::move(of_planes)),
      imaginary_planes(std::move(of_imaginary_planes)) {}

ProblemStatement::ProblemStatement() = default;
ProblemStatement::ProblemStatement(const ProblemStatement&) = default;
ProblemStatement::ProblemStatement(ProblemStatement&&) noexcept = default;
ProblemStatement& ProblemStatement::operator=(const ProblemStatement&) = default;
ProblemStatement& ProblemStatement::operator=(ProblemStatement&&) noexcept = default;
ProblemStatement::~ProblemStatement() = default;

Figure Figure::scaled(int exponent) const {
  const auto scale = [exponent](double x) { return std::ldexp(x, exponent); };
  Figure result = *this;
  result.points = points.unaryExpr(scale);
  result.imaginary = imaginary.unaryExpr(scale);
  for (auto* of_lines : {&result.lines, &result.imaginary_lines})
    for (LinePosition& line : *of_lines) line.point = line.point.unaryExpr(scale);
  for (auto* of_planes : {&result.planes, &result.imaginary_planes})
    for (PlanePosition& plane : *of_planes) plane.offset = scale(plane.offset);
  return result;
}

bool ProblemStatement::is_fixed(int entity) const {
  const std::size_t point = static_cast<std::size_t>(entity);
  if (is_point(entity)) return point < fixed_points.size() && fixed_points[point].has_value();
  if (is_plane(entity)) {
    const auto plane = static_cast<std::size_t>(plane_of(entity));
    return plane < fixed_planes.size() && fixed_planes[plane].has_value();
  }
  const auto line = static_cast<std::size_t>(line_of(entity));
  return line < fixed_lines.size() && fixed_lines[line].has_value();
}

bool ProblemStatement::has_fixed() const {
  for (int entity = 0; entity < entity_count(); ++entity)
    if (is_fixed(entity)) return true;
  return false;
}

OperandKind kind_of(const ProblemStatement& problem, const Operand& operand) {
  if (operand.is_segment()) return OperandKind::segment;
  if (problem.is_point(operand.entity)) return OperandKind::point;
  return problem.is_line(operand.entity) ? OperandKind::line : OperandKind::plane;
}

std::vector<int> bodies_with(const ProblemStatement& problem, int entity) {
  std::vector<int> bodies;
  for (int body = 0; body < static_cast<int>(problem.bodies.size()); ++body)
    for (const BodyElement& element : problem.bodies[static_cast<std::size_t>(body)].elements)
      if (element.entity == entity) bodies.push_back(body);
  return bodies;
}

std::vector<BentLength> bent_lengths(const ProblemStatement& problem) {
  const InterpolationChoice& choice = problem.interpolation;
  if (choice.bends) return *choice.bends;
  if (problem.constraints.empty()) return {};
  return {{choice.bent >= 0 ? choice.bent : static_cast<int>(problem.constraints.size()) - 1, {choice.bend}}};
}

std::size_t fixed_text_row(const ProblemStatement& problem, int entity) {
  const auto points = static_cast<int>(problem.points.size());
  return static_cast<std::size_t>(std::min(entity, points) + 2 * std::max(0, entity - points));
}

bool is_flat(const RigidBody& body, int dimension) {
  const auto d = static_cast<std::size_t>(dimension);
  return std::all_of(body.elements.begin(), body.elements.end(), [&](const BodyElement& element) {
    return element.numbers.size() == d && element.numbers[d - 1].value == 0;
  });
}

Convention convention_of(const ProblemStatement& problem) {
  if (problem.has_fixed()) return Convention::in_the_given_frame;
  const bool is_oriented = std::any_of(problem.relations.begin(), problem.relations.end(),
                                       [](const Relation& r) { return r.sign != 0; });
  const bool is_chiral =
      std::any_of(problem.bodies.begin(), problem.bodies.end(),
                  [&](const RigidBody& body) { return !is_flat(body, problem.dimension); });
  return is_oriented || is_chiral ? Convention::up_to_motion : Convention::up_to_reflection;
}

Convention frame_convention(const ProblemStatement& problem) {
  return problem.file_frame ? Convention::up_to_motion : convention_of(problem);
}

FrameImages frame_images(const ProblemStatement& problem) {
  const int points = static_cast<int>(problem.points.size());
  if (problem.is_anchored()) return {1, 1};
  if (problem.is_general()) return {frame_convention(problem) == Convention::up_to_reflection ? 2 : 1, 1};
  if (!problem.lines.empty()) return {points == 1 ? 1 : 4, 2};
  return {points <= problem.dimension ? 1 : 2, 1 << (std::min(points, problem.dimension) - 1)};
}

int sign_patterns(bool is_anchored, int dimension) { return is_anchored ? 1 : 1 << dimension; }

}  // namespace gcs
