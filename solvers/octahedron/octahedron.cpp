#include "solvers/octahedron/octahedron.hpp"

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

std::optional<Octahedron> find_octahedron(const Scene& scene, const CoreReduction& reduction) {
  std::vector<std::array<int, 2>> pairs;
  for (const int e : reduction.core_constraints) pairs.push_back(scene.problem().constraints[e].between);
  return octahedron_of(reduction.core, pairs);
}

std::optional<Octahedron> find_octahedron_with_planes(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  if (!problem.lines.empty() || !problem.bodies.empty()) return std::nullopt;
  std::vector<int> elements(static_cast<std::size_t>(problem.entity_count()));
  std::iota(elements.begin(), elements.end(), 0);
  std::vector<std::array<int, 2>> pairs;
  for (const DistanceConstraint& constraint : problem.constraints) pairs.push_back(constraint.between);
  for (const Relation& relation : problem.relations) {
    const auto pair = given_pair(scene, relation);
    if (!pair) return std::nullopt;
    pairs.push_back(pair->between);
  }
  const auto octahedron = octahedron_of(elements, pairs);
  const bool has_points = octahedron && std::ranges::all_of(octahedron->pair, [&](const auto& pair) {
                            return problem.is_point(pair[0]);
                          });
  return has_points ? octahedron : std::nullopt;
}

double roundness_of_base(const PairEntries& entries, const Octahedron& octahedron) {
  const int a = octahedron.pair[0][0];
  const int b = octahedron.pair[1][0];
  const int c = octahedron.pair[2][0];
  if (entries.is_plane(a) || entries.is_plane(b) || entries.is_plane(c)) return -1;
  const double longest = std::max({entries(a, b), entries(b, c), entries(c, a)});
  const double u = entries(a, b) / longest;
  const double v = entries(b, c) / longest;
  const double w = entries(c, a) / longest;
  return 2 * (u * v + v * w + w * u) - (u * u + v * v + w * w);
}

Octahedron with_round_base(const Octahedron& octahedron, const PairEntries& entries) {
  Octahedron best = octahedron;
  for (int swaps = 1; swaps < 8; ++swaps) {
    Octahedron other = octahedron;
    for (int i = 0; i < 3; ++i)
      if (swaps >> i & 1) std::swap(other.pair[i][0], other.pair[i][1]);
    if (roundness_of_base(entries, other) > roundness_of_base(entries, best)) best = other;
  }
  return best;
}

}  // namespace gcs
