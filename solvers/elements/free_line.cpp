#include <algorithm>

#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

bool is_line(const ProblemStatement& problem, const Operand& of) {
  return !of.is_segment() && problem.is_line(of.entity);
}

bool is_plane(const ProblemStatement& problem, const Operand& of) {
  return !of.is_segment() && problem.is_plane(of.entity);
}

/// Precondition: its operands are of a kind that the type knows.
bool shares_direction(const ProblemStatement& problem, Relation relation) {
  return find_kind(problem, relation)->shares_direction;
}

/// The other line of a relation that says that two have one direction; −1 where it says nothing of the kind.
int parallel_line(const ProblemStatement& problem, const Relation& relation, int line) {
  const auto& of = relation.of;
  if (of.size() != 2 || !is_line(problem, of[0]) || !is_line(problem, of[1])) return -1;
  if (!shares_direction(problem, relation)) return -1;
  const int a = problem.line_of(of[0].entity), b = problem.line_of(of[1].entity);
  if (a == line) return b;
  return b == line ? a : -1;
}

}  // namespace

LineForms free_line(SystemBuilder& builder, SignMask turning,
                    const std::function<ComplexLine(const Placement&)>& where) {
  LineForms line;
  line.turning = turning;
  line.foot = builder.vector();
  line.direction = builder.vector(turning);
  builder.define([where, d = builder.dimension()](const Placement& at, const ComplexValues&) {
    const ComplexLine known = where(at);
    ComplexValues values = components(known.point, d);
    const ComplexValues direction = components(known.direction, d);
    values.insert(values.end(), direction.begin(), direction.end());
    return values;
  });
  builder.add(Equation().plus(line.direction, line.direction).equals(exactly(1)));
  builder.add(Equation().plus(line.foot, line.direction).equals());
  return line;
}

LineForms further_line(SystemBuilder& builder, const std::vector<int>& through) {
  return free_line(builder, builder.new_turning(), [through](const Placement& at) {
    const Eigen::Vector3cd a = at.points.col(through[0]), b = at.points.col(through[1]);
    return normalised(ComplexLine{a, b - a});
  });
}

LineForms line_along(SystemBuilder& builder, const VectorForm& direction, SignMask turning, int number) {
  LineForms line{builder.vector(), direction, turning};
  builder.define([number, d = builder.dimension()](const Placement& at, const ComplexValues&) {
    return components(at.lines[static_cast<std::size_t>(number)].point, d);
  });
  builder.add(Equation().plus(line.foot, line.direction).equals());
  return line;
}

void state_on_line(SystemBuilder& builder, const VectorForm& point, const LineForms& line, int value) {
  const LinearForm along = builder.unknown(line.turning);
  builder.define([point, line](const Placement&, const ComplexValues& x) {
    const Eigen::Vector3cd way = vector_at(point, x) - vector_at(line.foot, x);
    return ComplexValues{bilinear_product(way, vector_at(line.direction, x))};
  });
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(builder.dimension()); ++axis)
    builder.add(
        Equation().plus(line.foot[axis]).plus(along, line.direction[axis]).minus(point[axis]).equals(),
        value);
}

void state_same_direction(SystemBuilder& builder, const VectorForm& v, const VectorForm& u) {
  const LinearForm sense = builder.unknown(0);
  builder.define([u, v](const Placement&, const ComplexValues& x) {
    return ComplexValues{bilinear_product(vector_at(u, x), vector_at(v, x))};
  });
  for (std::size_t axis = 0; axis < static_cast<std::size_t>(builder.dimension()); ++axis)
    builder.add(Equation().plus(v[axis]).minus(sense, u[axis]).equals(), gap_value);
}

std::vector<int> parallel_lines(const ProblemStatement& problem, int line) {
  std::vector<int> found{line};
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const Relation& relation : problem.relations) {
      const int other = parallel_line(problem, relation, found[i]);
      if (other >= 0 && std::find(found.begin(), found.end(), other) == found.end()) found.push_back(other);
    }
  return found;
}

std::vector<int> planes_across(const ProblemStatement& problem, const std::vector<int>& lines) {
  std::vector<int> planes;
  for (const Relation& relation : problem.relations) {
    if (relation.of.size() != 2) continue;
    for (std::size_t i = 0; i < 2; ++i) {
      const Operand &line = relation.of[i], &plane = relation.of[1 - i];
      if (!is_line(problem, line) || !is_plane(problem, plane) || !shares_direction(problem, relation))
        continue;
      if (std::find(lines.begin(), lines.end(), problem.line_of(line.entity)) != lines.end())
        planes.push_back(problem.plane_of(plane.entity));
    }
  }
  return planes;
}

}  // namespace gcs
