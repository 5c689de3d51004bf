#include "solvers/elements/constraint_types.hpp"

#include <algorithm>
#include <utility>

namespace gcs {
namespace {

std::vector<OperandKind> operand_kinds(const ProblemStatement& problem, const Relation& relation) {
  std::vector<OperandKind> kinds;
  for (const Operand& operand : relation.of) kinds.push_back(kind_of(problem, operand));
  return kinds;
}

}  // namespace

const ConstraintType* find_constraint_type(const std::string& name) {
  const auto types = constraint_types();
  const auto found = std::ranges::find(types, name, &ConstraintType::name);
  return found == types.end() ? nullptr : &*found;
}

ConstraintType::Value value_kind(const Relation& relation) {
  const ConstraintType* type = find_constraint_type(relation.type);
  return type == nullptr ? ConstraintType::Value::none : type->value;
}

const ConstraintKind* find_kind(const ProblemStatement& problem, Relation& relation) {
  const ConstraintType* type = find_constraint_type(relation.type);
  if (type == nullptr) return nullptr;
  if (type->is_of_points()) return &type->kinds.front();
  // A distance of planes is seen from the first, which therefore stays the first.
  if (relation.of.size() == 2 && kind_of(problem, relation.of[0]) > kind_of(problem, relation.of[1]))
    std::swap(relation.of[0], relation.of[1]);
  const auto found =
      std::ranges::find(type->kinds, operand_kinds(problem, relation), &ConstraintKind::between);
  return found == type->kinds.end() ? nullptr : &*found;
}

void state_nothing(SystemBuilder&, const StatedRelation&) {}

}  // namespace gcs
