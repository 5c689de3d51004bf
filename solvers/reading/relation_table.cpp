#include "solvers/reading/relation_table.hpp"

#include <algorithm>
#include <array>

#include "solvers/reading/nearest_name.hpp"

namespace gcs {
namespace {

using Pair = std::pair<OperandKind, OperandKind>;
using enum OperandKind;

struct TypeEntry {
  RelationType type;
  const char* name;
  std::vector<Pair> pairs;
  bool only_in_space = false;
};

/// In the order of RelationType.
const std::vector<TypeEntry>& table() {
  static const std::vector<Pair> directions{{line, line},  {segment, line},  {segment, segment},
                                            {line, plane}, {segment, plane}, {plane, plane}};
  static const std::vector<TypeEntry> entries{
      {RelationType::distance,
       "distance",
       {{point, point}, {point, line}, {point, plane}, {line, line}, {line, plane}, {plane, plane}}},
      {RelationType::angle, "angle", directions},
      {RelationType::on, "on", {{point, line}, {point, plane}, {line, plane}}},
      {RelationType::meet, "meet", {{line, line}}, true},
      {RelationType::parallel, "parallel", directions},
      {RelationType::perpendicular, "perpendicular", directions},
      {RelationType::collinear, "collinear", {}},
      {RelationType::coplanar, "coplanar", {}, true},
      {RelationType::orientation, "orientation", {}}};
  return entries;
}

const TypeEntry& entry(RelationType type) { return table()[static_cast<std::size_t>(type)]; }

std::string word(OperandKind kind) {
  static const std::array<const char*, 4> words{"point", "line", "plane", "segment"};
  return words[static_cast<std::size_t>(kind)];
}

bool has_plane(const Pair& pair) { return pair.first == plane || pair.second == plane; }

}  // namespace

std::optional<RelationType> relation_type(const std::string& name) {
  for (const TypeEntry& entry : table())
    if (entry.name == name) return entry.type;
  return std::nullopt;
}

std::string name_of(RelationType type) { return entry(type).name; }

std::string name_of(Relation::Form form) {
  static const std::array<const char*, 5> names{"", "length", "squared", "degrees", "cosine"};
  return names[static_cast<std::size_t>(form)];
}

std::vector<std::string> relation_type_names() {
  std::vector<std::string> names;
  for (const TypeEntry& entry : table()) names.emplace_back(entry.name);
  return names;
}

bool is_of_pair(RelationType type) { return !entry(type).pairs.empty(); }

bool is_only_in_space(RelationType type) { return entry(type).only_in_space; }

std::vector<Pair> pairs_of(RelationType type, int dimension) {
  std::vector<Pair> pairs = entry(type).pairs;
  if (dimension == 2) std::erase_if(pairs, has_plane);
  return pairs;
}

std::string words(const Pair& pair) { return word(pair.first) + "–" + word(pair.second); }

std::vector<int> entities_of(const std::vector<Operand>& operands) {
  std::vector<int> entities;
  for (const Operand& operand : operands) {
    entities.push_back(operand.entity);
    if (operand.is_segment()) entities.push_back(operand.end);
  }
  return entities;
}

std::string operand_names(const ProblemStatement& problem, const std::vector<Operand>& operands) {
  std::vector<std::string> names;
  for (const Operand& operand : operands)
    names.push_back(problem.name(operand.entity) +
                    (operand.is_segment() ? "–" + problem.name(operand.end) : std::string()));
  return quoted_list(names);
}

Operand undirected(const Operand& operand) {
  if (!operand.is_segment()) return operand;
  const auto [first, second] = std::minmax(operand.entity, operand.end);
  return {first, second};
}

}  // namespace gcs
