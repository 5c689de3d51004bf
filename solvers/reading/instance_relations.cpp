#include "solvers/reading/instance_relations.hpp"

#include <algorithm>
#include <set>

#include "solvers/reading/instance_bodies.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/instance_values.hpp"
#include "solvers/reading/nearest_name.hpp"
#include "solvers/reading/relation_table.hpp"

namespace gcs {
namespace {

RelationType read_type_of_distances(const JsonCursor& cursor, const std::string& type) {
  if (type == "distance") return RelationType::distance;
  std::string remedy = "the only known type is 'distance'";
  if (type == "incidence" || type == "coincidence" || type == "on")
    remedy += "; a point on a line is a distance of length 0";
  cursor.fail("constraints of type '" + type + "' are not supported",
              relation_type(type) ? general_format_remedy(remedy) : remedy);
}

RelationType read_type(const JsonCursor& constraint, InstanceFormat format, const ProblemStatement& problem) {
  const JsonCursor cursor = constraint.required("type");
  const std::string name = cursor.text();
  if (format == InstanceFormat::distances) return read_type_of_distances(cursor, name);
  const auto type = relation_type(name);
  if (!type)
    cursor.fail("there is no constraint of type '" + name + "'",
                "did you mean '" + nearest_name(name, relation_type_names()) + "'? The types are " +
                    quoted_list(relation_type_names()));
  if (problem.dimension == 2 && is_only_in_space(*type))
    cursor.fail("'" + name + "' is for space only", "leave it out or give \"dimension\": 3");
  return *type;
}

void allow_members(const JsonCursor& constraint, RelationType type) {
  if (type == RelationType::distance) {
    constraint.allow_members({"id", "type", "between", "length", "squared"});
  } else if (type == RelationType::angle) {
    constraint.allow_members({"id", "type", "between", "degrees", "cosine"});
  } else if (type == RelationType::orientation) {
    constraint.allow_members({"id", "type", "of", "sign"});
  } else {
    constraint.allow_members({"id", "type", "between"});
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

void refuse_same(const JsonCursor& between, const Relation& relation, const ProblemStatement& problem) {
  if (undirected(relation.of[0]) != undirected(relation.of[1])) return;
  const std::string names = operand_names(problem, {relation.of[0]});
  between.fail(relation.type == RelationType::distance
                   ? names + " has no distance to itself"
                   : names + " is on both sides of '" + name_of(relation.type) + "'",
               "name two different entities");
}

std::string pair_words(RelationType type, int dimension) {
  std::string result;
  const auto pairs = pairs_of(type, dimension);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    result += (i == 0 ? "" : i + 1 == pairs.size() ? " and " : ", ") + words(pairs[i]);
  return result;
}

void refuse_unknown_pair(const JsonCursor& between, const Relation& relation,
                         const ProblemStatement& problem) {
  const std::pair kinds{kind_of(problem, relation.of[0]), kind_of(problem, relation.of[1])};
  const auto pairs = pairs_of(relation.type, problem.dimension);
  const auto is_this = [&](const auto& pair) {
    return pair == kinds || pair == std::pair(kinds.second, kinds.first);
  };
  if (std::any_of(pairs.begin(), pairs.end(), is_this)) return;
  const std::string name = "'" + name_of(relation.type) + "'";
  between.fail(name + " is not between " + words(kinds),
               name + " is between " + pair_words(relation.type, problem.dimension));
}

/// Of gcsbench-instance/1.
void refuse_two_lines(const JsonCursor& between, const Relation& relation, const ProblemStatement& problem) {
  if (problem.is_point(relation.of[0].entity) || problem.is_point(relation.of[1].entity)) return;
  between.fail("distances between two lines are not supported",
               general_format_remedy("name a point and a line, or two points"));
}

void read_pair(const JsonCursor& between, InstanceFormat format, const ProblemStatement& problem,
               Relation& relation) {
  const bool only_names = format == InstanceFormat::distances;
  for (const JsonCursor& end :
       between.elements(2, only_names ? "names of points or lines" : "names or segments"))
    relation.of.push_back(only_names ? Operand{entity_number(problem, end.name(), end), -1}
                                     : read_operand(end, problem));
  refuse_same(between, relation, problem);
  if (only_names) {
    refuse_two_lines(between, relation, problem);
  } else {
    refuse_unknown_pair(between, relation, problem);
  }
}

/// As many points as the type needs to say something.
std::vector<JsonCursor> point_list(const JsonCursor& list, RelationType type, int dimension) {
  if (type == RelationType::orientation)
    return list.elements(static_cast<std::size_t>(dimension) + 1, "points");
  std::vector<JsonCursor> points = list.elements();
  const bool is_plane = type == RelationType::coplanar;
  if (points.size() < (is_plane ? 4U : 3U))
    list.fail(
        "there are " + std::to_string(points.size()) + " elements",
        std::string("'") + name_of(type) + "' is of " + (is_plane ? "four" : "three") + " points or more");
  return points;
}

void read_points(const JsonCursor& list, const ProblemStatement& problem, Relation& relation) {
  std::set<int> seen;
  for (const JsonCursor& cursor : point_list(list, relation.type, problem.dimension)) {
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
      relation.type == RelationType::distance
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
  Relation relation;
  relation.type = read_type(constraint, format, problem);
  allow_members(constraint, relation.type);
  const auto id = constraint.optional("id");
  relation.id = id ? id->name() : "a" + std::to_string(place);
  const JsonCursor operands =
      constraint.required(relation.type == RelationType::orientation ? "of" : "between");
  if (is_of_pair(relation.type)) {
    read_pair(operands, format, problem, relation);
  } else {
    read_points(operands, problem, relation);
  }
  refuse_fixed(operands, relation, problem);
  refuse_one_body(operands, relation, problem);
  read_value(constraint, format, problem, relation);
  return relation;
}

ParallelClasses::ParallelClasses(const ProblemStatement& problem) {
  for (const Relation& relation : problem.relations) {
    if (relation.type != RelationType::parallel) continue;
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

bool needs_parallel(const ProblemStatement& problem, const Relation& relation) {
  if (relation.type != RelationType::distance) return false;
  const OperandKind a = kind_of(problem, relation.of[0]), b = kind_of(problem, relation.of[1]);
  if (a == OperandKind::point || b == OperandKind::point) return false;
  return problem.dimension == 2 || a == OperandKind::plane || b == OperandKind::plane;
}

}  // namespace gcs
