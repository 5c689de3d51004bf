#include "solvers/octahedron/octahedron.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace gcs {

SquaredLengths::SquaredLengths(const Scene& scene)
    : matrix_(Eigen::MatrixXd::Zero(scene.point_count(), scene.point_count())) {
  for (int e = 0; e < scene.constraint_count(); ++e) {
    const auto [p, q] = scene.problem().constraints[e].between;
    matrix_(p, q) = matrix_(q, p) = scene.target_lengths()[e] * scene.target_lengths()[e];
  }
}

std::optional<Octahedron> find_octahedron(const Scene& scene, const CoreReduction& reduction) {
  if (reduction.core.size() != 6 || reduction.core_constraints.size() != 12) return std::nullopt;
  std::vector<std::vector<bool>> edge(
      static_cast<std::size_t>(scene.point_count()),
      std::vector<bool>(static_cast<std::size_t>(scene.point_count()), false));
  for (int e : reduction.core_constraints) {
    const auto [p, q] = scene.problem().constraints[e].between;
    edge[p][q] = edge[q][p] = true;
  }
  Octahedron octahedron;
  std::size_t found = 0;
  for (std::size_t i = 0; i < 6; ++i)
    for (std::size_t j = i + 1; j < 6; ++j)
      if (!edge[reduction.core[i]][reduction.core[j]]) {
        if (found == 3) return std::nullopt;
        octahedron.pair[found++] = {reduction.core[i], reduction.core[j]};
      }
  std::vector<int> matched;
  for (const auto& [p, q] : octahedron.pair) matched.insert(matched.end(), {p, q});
  std::sort(matched.begin(), matched.end());
  const bool distinct = std::adjacent_find(matched.begin(), matched.end()) == matched.end();
  return found == 3 && distinct ? std::optional(octahedron) : std::nullopt;
}

double roundness_of_base(const SquaredLengths& lengths, const Octahedron& octahedron) {
  const int a = octahedron.pair[0][0];
  const int b = octahedron.pair[1][0];
  const int c = octahedron.pair[2][0];
  const double longest = std::max({lengths(a, b), lengths(b, c), lengths(c, a)});
  const double u = lengths(a, b) / longest;
  const double v = lengths(b, c) / longest;
  const double w = lengths(c, a) / longest;
  return 2 * (u * v + v * w + w * u) - (u * u + v * v + w * w);
}

Octahedron with_round_base(const Octahedron& octahedron, const SquaredLengths& lengths) {
  Octahedron best = octahedron;
  for (int swaps = 1; swaps < 8; ++swaps) {
    Octahedron other = octahedron;
    for (int i = 0; i < 3; ++i)
      if (swaps >> i & 1) std::swap(other.pair[i][0], other.pair[i][1]);
    if (roundness_of_base(lengths, other) > roundness_of_base(lengths, best)) best = other;
  }
  return best;
}

}  // namespace gcs
