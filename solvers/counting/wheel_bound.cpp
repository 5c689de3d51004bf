#include "solvers/counting/wheel_bound.hpp"

#include <algorithm>
#include <cstdint>
#include <set>
#include <vector>

namespace gcs {
namespace {

constexpr std::size_t most_spokes = 30;  // 2·4ⁿ is to fit 64 bits

using Neighbours = std::vector<std::set<int>>;

/// Whether a walk from neighbour to neighbour but through the hub comes round to all others.
bool is_rim_one_cycle(const Neighbours& neighbours, int hub) {
  const std::size_t spokes = neighbours.size() - 1;
  int last = hub, here = hub == 0 ? 1 : 0;
  const int first = here;
  for (std::size_t step = 1; step <= spokes; ++step) {
    std::set<int> next = neighbours[static_cast<std::size_t>(here)];
    next.erase(hub);
    next.erase(last);
    if (next.size() != (step == 1 ? 2 : 1)) return false;
    last = here;
    here = *next.begin();
    if ((here == first) != (step == spokes)) return false;
  }
  return true;
}

bool is_wheel(const Neighbours& neighbours) {
  const std::size_t spokes = neighbours.size() - 1;
  for (std::size_t hub = 0; hub <= spokes; ++hub)
    if (neighbours[hub].size() == spokes && is_rim_one_cycle(neighbours, static_cast<int>(hub))) return true;
  return false;
}

/// (1 + √3)ⁿ + (1 − √3)ⁿ
std::uint64_t power_sum(std::size_t n) {
  std::uint64_t before = 2, now = 2;
  for (std::size_t k = 1; k < n; ++k) {
    const std::uint64_t next = 2 * (now + before);
    before = now;
    now = next;
  }
  return now;
}

}  // namespace

std::optional<Natural> wheel_bound(const BoundProblem& problem) {
  const auto points = static_cast<std::size_t>(std::ranges::count(problem.on_line, true));
  const std::size_t spokes = points - 1;
  if (problem.dimension != 3 || points < 4 || spokes > most_spokes || problem.edges.size() != 2 * spokes)
    return std::nullopt;
  if (!std::all_of(problem.on_line.begin(), problem.on_line.begin() + static_cast<std::ptrdiff_t>(points),
                   [](bool is_beside) { return is_beside; }))
    return std::nullopt;
  Neighbours neighbours(points);
  for (const auto& [a, b] : problem.edges) {
    if (std::max(a, b) >= static_cast<int>(points) || a == b) return std::nullopt;
    neighbours[static_cast<std::size_t>(a)].insert(b);
    neighbours[static_cast<std::size_t>(b)].insert(a);
  }
  if (!is_wheel(neighbours)) return std::nullopt;
  return Natural((std::uint64_t{2} << 2 * spokes) - 4 * power_sum(spokes));
}

}  // namespace gcs
