#include "solvers/counting/three_lines_bound.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace gcs {
namespace {

constexpr std::size_t of_each = 3, all_pairs = 15;

/// The type of what is stated of each pair of elements, where that is a distance or an angle.
std::map<std::pair<int, int>, std::string> types_of_pairs(const ProblemStatement& problem) {
  std::map<std::pair<int, int>, std::string> types;
  for (const DistanceConstraint& c : problem.constraints)
    types.emplace(std::minmax(c.between[0], c.between[1]), "distance");
  for (const Relation& relation : problem.relations)
    if (relation.of.size() == 2 && std::ranges::none_of(relation.of, &Operand::is_segment) &&
        (relation.type == "distance" || relation.type == "angle"))
      types.emplace(std::minmax(relation.of[0].entity, relation.of[1].entity), relation.type);
  return types;
}

}  // namespace

std::optional<std::uint64_t> three_lines_bound(const ProblemStatement& problem) {
  if (problem.dimension != 3 || problem.points.size() != of_each || problem.lines.size() != of_each ||
      !problem.planes.empty() || !problem.bodies.empty() || problem.is_anchored() ||
      problem.constraints.size() + problem.relations.size() != all_pairs)
    return std::nullopt;
  const auto types = types_of_pairs(problem);
  if (types.size() != all_pairs) return std::nullopt;
  const auto angles = static_cast<std::size_t>(
      std::ranges::count_if(types, [](const auto& pair) { return pair.second == "angle"; }));
  if (angles == of_each) return 2 * (12 * 12 * 12 - 6 * (3 * 12 * 2 * 2 - 2 * 2 * 2 * 2));
  std::uint64_t bound = 2;
  for (std::size_t pair = 0; pair < of_each; ++pair) bound *= pair < angles ? 12 : 24;
  return bound;
}

}  // namespace gcs
