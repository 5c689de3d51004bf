#include "solvers/counting/bigraph_count.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace gcs {
namespace {

/// The ends of the edges on one side after contractions: parallel edges have the same number.
using EndNumbers = std::vector<std::uint16_t>;

EndNumbers end_numbers(const Bigraph& bigraph, EdgeSet edges, int side, const VertexClasses& classes) {
  EndNumbers numbers;
  for (std::size_t e = 0; e < bigraph.size(); ++e) {
    if ((edges >> e & 1) == 0) continue;
    const auto [low, high] =
        std::minmax({classes[bigraph[e].ends[side][0]], classes[bigraph[e].ends[side][1]]});
    numbers.push_back(static_cast<std::uint16_t>(low * most_bigraph_vertices + high));
  }
  return numbers;
}

/// The edge at that position among the members of the set.
std::size_t member(EdgeSet edges, std::size_t position) {
  for (; position > 0; --position) edges &= edges - 1;
  return static_cast<std::size_t>(std::countr_zero(edges));
}

/// Of those edges the one with most parallels on both sides together: as an edge to split by, or to decide
/// next, it leaves least to choose. Precondition: there are some.
std::size_t most_binding(const Bigraph& bigraph, EdgeSet among, const std::array<VertexClasses, 2>& classes) {
  const EndNumbers first = end_numbers(bigraph, among, 0, classes[0]);
  const EndNumbers second = end_numbers(bigraph, among, 1, classes[1]);
  std::size_t best = 0;
  std::ptrdiff_t most = -1;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const std::ptrdiff_t parallels = std::count(first.begin(), first.end(), first[i]) +
                                     std::count(second.begin(), second.end(), second[i]);
    if (parallels > most) best = i;
    most = std::max(most, parallels);
  }
  return member(among, best);
}

/// Finds all pairs (M, N) for which neither ᴹB nor Bᴺ has a loop: M is closed in G and N in H, that is, no
/// edge outside lies in a cycle with edges inside.
class SplitSearch {
 public:
  SplitSearch(const Bigraph& bigraph, std::int64_t& steps_left)
      : bigraph_(bigraph), all_(all_edges(bigraph)), steps_left_(steps_left) {}

  std::vector<std::array<EdgeSet, 2>> run() {
    State start;
    const std::size_t shared = most_binding(bigraph_, all_, start.classes);
    for (const int side : {0, 1}) give(start, shared, side);
    shared_ = EdgeSet{1} << shared;
    search(start);
    return std::move(found_);
  }

 private:
  /// parts[side] is contracted on that side and deleted on the other.
  struct State {
    std::array<EdgeSet, 2> parts{};
    std::array<VertexClasses, 2> classes;
  };

  void give(State& state, std::size_t e, int side) const {
    state.parts[side] |= EdgeSet{1} << e;
    state.classes[side].join(bigraph_[e].ends[side]);
  }

  /// Gives every edge that has become a loop on one side to that part. False when an edge is a loop of what
  /// is left on a side.
  bool close(State& state) const {
    for (std::size_t e = 0; e < bigraph_.size(); ++e) {
      const EdgeSet edge = EdgeSet{1} << e;
      if (edge == shared_) continue;
      for (const int side : {0, 1})
        if (state.classes[side].are_joined(bigraph_[e].ends[side])) state.parts[side] |= edge;
      if ((state.parts[0] & state.parts[1] & edge) != 0) return false;
    }
    return true;
  }

  void search(State state) {
    if (--steps_left_ < 0 || !close(state)) return;
    const EdgeSet open = all_ & ~(state.parts[0] | state.parts[1]);
    if (open == 0) {
      found_.push_back(state.parts);
      return;
    }
    const std::size_t next = most_binding(bigraph_, open, state.classes);
    for (const int side : {0, 1}) {
      State longer = state;
      give(longer, next, side);
      search(longer);
    }
  }

  const Bigraph& bigraph_;
  EdgeSet all_;
  EdgeSet shared_ = 0;
  std::int64_t& steps_left_;
  std::vector<std::array<EdgeSet, 2>> found_;
};

}  // namespace

std::optional<std::uint64_t> BigraphCounter::count(const Bigraph& bigraph) {
  const std::uint64_t result = lam(bigraph);
  return steps_left_ < 0 ? std::nullopt : std::optional(result);
}

std::uint64_t BigraphCounter::lam(const Bigraph& bigraph) {
  if (bigraph.empty()) return 1;
  const auto simple = simplified(bigraph);
  if (!simple) return 0;
  const Bigraph key = canonical(*simple);
  if (const auto known = known_.find(key); known != known_.end()) return known->second;
  const std::uint64_t result = sum_over_splits(key);
  known_.emplace(key, result);
  return result;
}

std::uint64_t BigraphCounter::sum_over_splits(const Bigraph& bigraph) {
  std::uint64_t sum = 0;
  for (const auto& [m, n] : SplitSearch(bigraph, steps_left_).run()) {
    if (steps_left_ < 0) break;
    sum += product(contracted(bigraph, 0, m), contracted(bigraph, 1, n));
  }
  return sum;
}

/// The smaller one first: it is often 0.
std::uint64_t BigraphCounter::product(Bigraph first, Bigraph second) {
  if (second.size() < first.size()) std::swap(first, second);
  const std::uint64_t count = lam(first);
  return count == 0 ? 0 : count * lam(second);
}

}  // namespace gcs
