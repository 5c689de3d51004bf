#include "solvers/reading/instance_relations.hpp"

#include <algorithm>
#include <array>
#include <set>

#include "solvers/elements/constraint_types.hpp"
#include "solvers/reading/instance_bodies.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/instance_values.hpp"
#include "solvers/reading/nearest_name.hpp"
#include "solvers/reading/relation_words.hpp"
#include "solvers/running/words.hpp"

namespace gcs {
namespace {

void refuse_other_than_distance(const JsonCursor& cursor, const std::string& type) {
  if (type == "distance") return;
  std::string remedy = "the only known type is 'distance'";
  if (type == "incidence" || type == "coincidence" || type == "on")
    remedy += "; a point on a line is a distance of length 0";
  cursor.fail("constraints of type '" + type + "' are not supported",
              find_constraint_type(type) ? general_format_remedy(remedy) : remedy);
}

std::vector<std::string> names_of_types() {
  std::vector<std::string> names;
  for (const ConstraintType& type : constraint_types()) names.push_back(type.name);
  return names;
}

const ConstraintType& read_type(const JsonCursor& constraint, InstanceFormat format,
                                const ProblemStatement& problem) {
  const JsonCursor cursor = constraint.required("type");
  const std::string name = cursor.text();
  if (format == InstanceFormat::distances) refuse_other_than_distance(cursor, name);
  const ConstraintType* type = find_constraint_type(name);
  if (type == nullptr)
    cursor.fail("there is no constraint of type '" + name + "'",
                "did you mean '" + nearest_name(name, names_of_types()) + "'? The types are " +
                    quoted_list(names_of_types()));
  if (problem.dimension == 2 && type->only_in_space)
    cursor.fail("'" + name + "' is for space only", "leave it out or give \"dimension\": 3");
  return *type;
}

/// The member that says what a constraint is between.
std::string operands_member(const ConstraintType& type) {
  return type.value == ConstraintType::Value::sign ? "of" : "between";
}

void allow_members(const JsonCursor& constraint, const ConstraintType& type) {
  switch (type.value) {
    case ConstraintType::Value::none:
      return constraint.allow_members({"id", "type", "between"});
    case ConstraintType::Value::length:
      return constraint.allow_members({"id", "type", "between", "length", "squared"});
    case ConstraintType::Value::angle:
      return constraint.allow_members({"id", "type", "between", "degrees", "cosine"});
    case ConstraintType::Value::sign:
      return constraint.allow_members({"id", "type", "of", "sign"});
  }
}

/// A name, or the segment [from, to].
Operand read_operand(const JsonCursor& cursor, const ProblemStatement& problem) {
  if (!cursor.is_array()) return {entity_number(problem, cursor.name(), cursor), -1};
  const auto ends = cursor.elements(2, "names of points: a segment");
  const Operand segment{point_number(problem, ends[0]), point_number(problem, ends[1])};
  if (segment.entity == segment.end)
    cursor.fail("the segment has '" + problem.name(segment.entity) + "' for both ends",
                "name two different points");
  return segment;
}

void refuse_same(const JsonCursor& between, const Relation& relation, const ConstraintType& type,
                 const ProblemStatement& problem) {
  if (undirected(relation.of[0]) != undirected(relation.of[1])) return;
  const std::string names = operand_names(problem, {relation.of[0]});
  between.fail(type.value == ConstraintType::Value::length
                   ? names + " has no " + type.name + " to itself"
                   : names + " is on both sides of '" + type.name + "'",
               "name two different entities");
}

/// From the least to the most: point, segment, line, plane.
std::vector<OperandKind> in_order_of_size(std::vector<OperandKind> kinds) {
  using enum OperandKind;
  static constexpr std::array order{point, segment, line, plane};
  std::ranges::sort(kinds, {}, [](OperandKind kind) { return std::ranges::find(order, kind); });
  return kinds;
}

/// What the type can be between in that dimension.
std::string known_operands(const ConstraintType& type, int dimension) {
  std::vector<std::string> known;
  for (const ConstraintKind& kind : type.kinds)
    if (dimension == 3 || std::ranges::count(kind.between, OperandKind::plane) == 0)
      known.push_back(words(in_order_of_size(kind.between)));
  return enumeration(known);
}

void refuse_unknown_kind(const JsonCursor& between, Relation& relation, const ConstraintType& type,
                         const ProblemStatement& problem) {
  std::vector<OperandKind> kinds;
  for (const Operand& operand : relation.of) kinds.push_back(kind_of(problem, operand));
  Relation in_order = relation;
  if (find_kind(problem, in_order) != nullptr) return;
  const std::string name = "'" + type.name + "'";
  between.fail(name + " is not between " + words(kinds),
               name + " is between " + known_operands(type, problem.dimension));
}

/// Of gcsbench-instance/1.
void refuse_two_lines(const JsonCursor& between, const Relation& relation, const ProblemStatement& problem) {
  if (problem.is_point(relation.of[0].entity) || problem.is_point(relation.of[1].entity)) return;
  between.fail("distances between two lines are not supported",
               general_format_remedy("name a point and a line, or two points"));
}

void read_operands(const JsonCursor& between, InstanceFormat format, const ProblemStatement& problem,
                   const ConstraintType& type, Relation& relation) {
  const bool only_names = format == InstanceFormat::distances;
  for (const JsonCursor& end :
       between.elements(2, only_names ? "names of points or lines" : "names or segments"))
    relation.of.push_back(only_names ? Operand{entity_number(problem, end.name(), end), -1}
                                     : read_operand(end, problem));
  refuse_same(between, relation, type, problem);
  if (only_names) {
    refuse_two_lines(between, relation, problem);
  } else {
    refuse_unknown_kind(between, relation, type, problem);
  }
}

/// As many points as the type needs to say something.
std::vector<JsonCursor> point_list(const JsonCursor& list, const ConstraintType& type, int dimension) {
  if (type.value == ConstraintType::Value::sign)
    return list.elements(static_cast<std::size_t>(dimension) + 1, "points");
  std::vector<JsonCursor> points = list.elements();
  if (points.size() < static_cast<std::size_t>(type.fewest_points))
    list.fail("there are " + std::to_string(points.size()) + " elements",
              "'" + type.name + "' is of " + std::to_string(type.fewest_points) + " points or more");
  return points;
}

void read_points(const JsonCursor& list, const ProblemStatement& problem, const ConstraintType& type,
                 Relation& relation) {
  std::set<int> seen;
  for (const JsonCursor& cursor : point_list(list, type, problem.dimension)) {
    relation.of.push_back({point_number(problem, cursor), -1});
    if (!seen.insert(relation.of.back().entity).second)
      cursor.fail(operand_names(problem, {relation.of.back()}) + " is named twice", "name different points");
  }
}

void refuse_fixed(const JsonCursor& operands, const Relation& relation, const ProblemStatement& problem) {
  const std::vector<int> entities = entities_of(relation.of);
  if (!std::all_of(entities.begin(), entities.end(), [&](int entity) { return problem.is_fixed(entity); }))
    return;
  operands.fail(
      entity_names(problem, entities) + " are " + (entities.size() == 2 ? "both" : "all") + " fixed",
      value_kind(relation) == ConstraintType::Value::length
          ? "leave this constraint out, the positions give the distance"
          : "leave this constraint out, the positions say whether it holds");
}

void refuse_one_body(const JsonCursor& operands, const Relation& relation, const ProblemStatement& problem) {
  const std::vector<int> entities = entities_of(relation.of);
  const int body = common_body(problem, entities);
  if (body < 0) return;
  operands.fail(
      entity_names(problem, entities) + " are elements of one body, '" + problem.bodies[body].name + "'",
      "leave this constraint out, the body has them in given positions");
}

}  // namespace

Relation read_relation(const JsonCursor& constraint, std::size_t place, InstanceFormat format,
                       const ProblemStatement& problem) {
  const ConstraintType& type = read_type(constraint, format, problem);
  allow_members(constraint, type);
  Relation relation;
  relation.type = type.name;
  const auto id = constraint.optional("id");
  relation.id = id ? id->name() : "a" + std::to_string(place);
  const JsonCursor operands = constraint.required(operands_member(type));
  if (type.is_of_points()) {
    read_points(operands, problem, type, relation);
  } else {
    read_operands(operands, format, problem, type, relation);
  }
  refuse_fixed(operands, relation, problem);
  refuse_one_body(operands, relation, problem);
  read_value(constraint, format, problem, relation);
  return relation;
}

ParallelClasses::ParallelClasses(const ProblemStatement& problem) {
  for (const Relation& relation : problem.relations) {
    if (relation.type != "parallel") continue;
    const bool is_plane = kind_of(problem, relation.of[0]) == OperandKind::plane;
    const bool both = is_plane == (kind_of(problem, relation.of[1]) == OperandKind::plane);
    if (both) {
      join(relation.of[0], relation.of[1]);
    } else {
      across_.emplace_back(relation.of[is_plane ? 1 : 0], relation.of[is_plane ? 0 : 1]);
    }
  }
}

bool ParallelClasses::joins(const Operand& a, const Operand& b) const {
  const auto same = [&](const Operand& x, const Operand& y) {
    return undirected(x) == undirected(y) || (class_of(x) >= 0 && class_of(x) == class_of(y));
  };
  return same(a, b) || std::any_of(across_.begin(), across_.end(), [&](const auto& pair) {
           return (same(pair.first, a) && same(pair.second, b)) ||
                  (same(pair.first, b) && same(pair.second, a));
         });
}

/// −1 of what no `parallel` names.
int ParallelClasses::class_of(const Operand& operand) const {
  const Operand key = undirected(operand);
  const auto found = classes_.find({key.entity, key.end});
  return found == classes_.end() ? -1 : found->second;
}

void ParallelClasses::join(const Operand& a, const Operand& b) {
  for (const Operand& operand : {undirected(a), undirected(b)})
    classes_.emplace(Key{operand.entity, operand.end}, static_cast<int>(classes_.size()));
  const int kept = class_of(a), given_up = class_of(b);
  for (auto& [key, number] : classes_)
    if (number == given_up) number = kept;
}

bool needs_parallel(const ProblemStatement& problem, Relation relation) {
  using enum ConstraintKind::Joined;
  const ConstraintKind* kind = find_kind(problem, relation);
  return kind->joined == always || (kind->joined == in_the_plane && problem.dimension == 2);
}

}  // namespace gcs
