#include "solvers/reading/relation_words.hpp"

#include <algorithm>
#include <array>

#include "solvers/reading/nearest_name.hpp"

namespace gcs {
namespace {

std::string word(OperandKind kind) {
  static const std::array<const char*, 4> words{"point", "line", "plane", "segment"};
  return words[static_cast<std::size_t>(kind)];
}

}  // namespace

std::string name_of(Relation::Form form) {
  static const std::array<const char*, 5> names{"", "length", "squared", "degrees", "cosine"};
  return names[static_cast<std::size_t>(form)];
}

std::string words(const std::vector<OperandKind>& kinds) {
  std::string result;
  for (const OperandKind kind : kinds) result += (result.empty() ? "" : "–") + word(kind);
  return result;
}

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
