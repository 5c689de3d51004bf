#include "solvers/structure/octahedral_pairs.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace gcs {
namespace {

/// Six elements with twelve pairs.
std::optional<Octahedron> octahedron_of(const std::vector<int>& elements,
                                        const std::vector<std::array<int, 2>>& pairs) {
  if (elements.size() != 6 || pairs.size() != 12) return std::nullopt;
  std::set<std::pair<int, int>> given;
  for (const auto& [p, q] : pairs) given.insert(std::minmax(p, q));
  Octahedron octahedron;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i + 1; j < 6; ++j)
      if (!given.contains(std::minmax(elements[i], elements[j]))) {
        if (found == 3) return std::nullopt;
        octahedron.pair[found++] = {elements[i], elements[j]};
      }
  std::vector<int> matched;
  for (const auto& [p, q] : octahedron.pair) matched.insert(matched.end(), {p, q});
  std::sort(matched.begin(), matched.end());
  const bool distinct = std::adjacent_find(matched.begin(), matched.end()) == matched.end();
  return found == 3 && distinct ? std::optional(octahedron) : std::nullopt;
}

}  // namespace

std::optional<Octahedron> find_octahedron(const ProblemStatement& problem, const CoreReduction& reduction) {
  std::vector<std::array<int, 2>> pairs;
  for (const int e : reduction.core_constraints) pairs.push_back(problem.constraints[e].between);
  return octahedron_of(reduction.core, pairs);
}

std::optional<Octahedron> find_octahedron_with_planes(const ProblemStatement& problem) {
  if (!problem.lines.empty() || !problem.bodies.empty()) return std::nullopt;
  std::vector<int> elements(static_cast<std::size_t>(problem.entity_count()));
  std::iota(elements.begin(), elements.end(), 0);
  std::vector<std::array<int, 2>> pairs;
  for (const DistanceConstraint& constraint : problem.constraints) pairs.push_back(constraint.between);
  for (const Relation& relation : problem.relations) {
    const auto pair = pair_with_plane(problem, relation);
    if (!pair) return std::nullopt;
    pairs.push_back(*pair);
  }
  const auto octahedron = octahedron_of(elements, pairs);
  const bool has_points = octahedron && std::ranges::all_of(octahedron->pair, [&](const auto& pair) {
                            return problem.is_point(pair[0]);
                          });
  return has_points ? octahedron : std::nullopt;
}

std::optional<std::array<int, 2>> pair_with_plane(const ProblemStatement& problem, const Relation& relation) {
  if (relation.of.size() != 2 || relation.of[0].is_segment() || relation.of[1].is_segment())
    return std::nullopt;
  const std::array<int, 2> between{relation.of[0].entity, relation.of[1].entity};
  if (problem.is_line(between[0]) || problem.is_line(between[1])) return std::nullopt;
  const int planes = problem.is_plane(between[0]) + problem.is_plane(between[1]);
  const bool is_height = planes == 1 && (relation.type == "distance" || relation.type == "on");
  const bool is_angle = planes == 2 && (relation.type == "angle" || relation.type == "perpendicular");
  return is_height || is_angle ? std::optional(between) : std::nullopt;
}

}  // namespace gcs
