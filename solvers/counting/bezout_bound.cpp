#include "solvers/counting/bezout_bound.hpp"

#include <algorithm>
#include <utility>

#include "solvers/counting/infinite_solutions.hpp"
#include "solvers/counting/orientation_count.hpp"

namespace gcs {
namespace {

/// Of all references together: some seconds, and some tenths.
constexpr std::int64_t most_states = 2'000'000, most_sets = 1'000'000;

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

/// Only of points in space it is known where they are at infinity.
std::vector<InfiniteSolutions> infinite_solutions_of(const BoundProblem& problem,
                                                     const std::vector<int>& reference,
                                                     std::int64_t& sets_left) {
  const bool is_beside_line = std::ranges::find(problem.on_line, true) != problem.on_line.end();
  if (problem.dimension != 3 || !problem.are_points || is_beside_line) return {};
  return infinite_solutions(problem.on_line.size(), problem.edges, reference, sets_left);
}

}  // namespace

std::optional<BezoutBound> smallest_bezout_bound(const BoundProblem& problem) {
  std::optional<BezoutBound> smallest;
  std::int64_t states_left = most_states, sets_left = most_sets;
  for (std::size_t i = 0; i < problem.references.size(); ++i) {
    const auto all = bezout_bound(problem, problem.references[i], states_left);
    if (!all) continue;
    BezoutBound bound{*all, i};
    for (InfiniteSolutions& some : infinite_solutions_of(problem, problem.references[i], sets_left)) {
      bound.fixed_frame = bound.fixed_frame - some.count;
      bound.at_infinity.push_back(std::move(some.points));
    }
    if (!smallest || bound.fixed_frame < smallest->fixed_frame) smallest = std::move(bound);
  }
  return smallest;
}

}  // namespace gcs
