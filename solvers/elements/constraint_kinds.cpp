#include "solvers/elements/constraint_kinds.hpp"

#include <utility>

namespace gcs {
const ConstraintKind* find_kind(const ProblemStatement& problem, Relation& relation) {
  std::optional<std::array<OperandKind, 2>> between;
  if (relation.of.size() == 2) {
    // A distance of planes is seen from the first, which therefore stays the first.
    if (kind_of(problem, relation.of[0]) > kind_of(problem, relation.of[1]))
      std::swap(relation.of[0], relation.of[1]);
    between = {kind_of(problem, relation.of[0]), kind_of(problem, relation.of[1])};
  }
  for (const auto rows : {distance_kinds(), angle_kinds(), incidence_kinds(), direction_kinds()})
    for (const ConstraintKind& row : rows)
      if (row.type == relation.type && row.between == between) return &row;
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
