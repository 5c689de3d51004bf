#include "solvers/elements/constraint_kinds.hpp"

#include <algorithm>
#include <string>

namespace gcs {
namespace {

std::string between(const ProblemStatement& problem, const Relation& relation) {
  if (relation.type == RelationType::collinear || relation.type == RelationType::coplanar ||
      relation.type == RelationType::orientation)
    return "points";
  std::string kinds;
  for (const Operand& operand : relation.of)
    kinds += (kinds.empty() ? "" : " ") + std::string(operand_kind(problem, operand));
  return kinds;
}

}  // namespace

std::string_view operand_kind(const ProblemStatement& problem, const Operand& operand) {
  if (operand.is_segment()) return "segment";
  if (problem.is_point(operand.entity)) return "point";
  return problem.is_line(operand.entity) ? "line" : "plane";
}

const ConstraintKind* find_kind(const ProblemStatement& problem, Relation& relation) {
  if (relation.of.size() == 2 &&
      operand_kind(problem, relation.of[0]) > operand_kind(problem, relation.of[1]))
    std::swap(relation.of[0], relation.of[1]);
  // A distance of planes is seen from the first, which therefore stays the first.
  const std::string kinds = between(problem, relation);
  for (const auto rows : {distance_kinds(), angle_kinds(), incidence_kinds(), direction_kinds()})
    for (const ConstraintKind& row : rows)
      if (row.type == relation.type && row.between == kinds) return &row;
  return nullptr;
}

LinearForm product_unknown(SystemBuilder& builder, const VectorForm& left, const VectorForm& right,
                           SignMask turning) {
  const LinearForm product = builder.unknown(turning);
  builder.define([left, right](const Placement&, const ComplexValues& x) {
    std::complex<double> sum = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) sum += value_at(left[axis], x) * value_at(right[axis], x);
    return ComplexValues{sum};
  });
  builder.add(Equation().plus(product).minus(left, right).equals());
  return product;
}

}  // namespace gcs
