#include "solvers/counting/bezout_bound.hpp"

#include <algorithm>

#include "solvers/counting/orientation_count.hpp"

namespace gcs {
namespace {

/// Of all references together: some seconds.
constexpr std::int64_t most_states = 2'000'000;

std::optional<Natural> bezout_bound(const BoundProblem& problem, const std::vector<int>& reference,
                                    std::int64_t& states_left) {
  const auto is_free = [&](int point) {
    return std::find(reference.begin(), reference.end(), point) == reference.end();
  };
  std::vector<int> outdegrees(problem.on_line.size(), 0);
  int doublings = 0;
  for (int point = 0; point < static_cast<int>(outdegrees.size()); ++point) {
    if (!is_free(point)) continue;
    outdegrees[point] = problem.dimension - (problem.on_line[point] ? 1 : 0);
    doublings += problem.on_line[point] ? 2 : 1;
  }
  std::vector<std::array<int, 2>> edges;
  for (const auto& edge : problem.edges)
    if (is_free(edge[0]) || is_free(edge[1])) edges.push_back(edge);
  const auto orientations = count_orientations(edges, outdegrees, states_left);
  if (!orientations) return std::nullopt;
  return Natural::power_of_two(doublings) * *orientations;
}

}  // namespace

std::optional<BezoutBound> smallest_bezout_bound(const BoundProblem& problem) {
  std::optional<BezoutBound> smallest;
  std::int64_t states_left = most_states;
  for (std::size_t i = 0; i < problem.references.size(); ++i) {
    const auto bound = bezout_bound(problem, problem.references[i], states_left);
    if (bound && (!smallest || *bound < smallest->fixed_frame)) smallest = BezoutBound{*bound, i};
  }
  return smallest;
}

}  // namespace gcs
