/// Edge by edge is given to M, which is contracted in G and deleted in H, or to N, the other way round. An edge that
/// has become a loop on a side belongs to the part that is contracted there, and edges that have become parallel on a
/// side to one and the same part. What the ranks must come to can be seen on the way: with
/// f = rank_H(E) − rank_H(N) + rank_G(M) − |M| and g, the same with the sides exchanged, f + g is the number of open
/// edges, every decision lowers one of them by 1 and neither ever rises, and at the end both are 0.

#include "solvers/counting/split_search.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>

#include "solvers/counting/bits.hpp"

namespace gcs {
namespace {

/// Edges in classes.
class EdgeClasses {
 public:
  explicit EdgeClasses(std::size_t edges) : edges_(edges) {
    std::iota(parent_.begin(), parent_.begin() + static_cast<std::ptrdiff_t>(edges), std::uint8_t{0});
  }

  void join(std::size_t a, std::size_t b) { parent_[root(a)] = static_cast<std::uint8_t>(root(b)); }

  /// With the members of each class at one of them, elsewhere empty sets.
  std::array<EdgeSet, most_biedges> members() const {
    std::array<EdgeSet, most_biedges> sets;
    std::fill_n(sets.begin(), edges_, EdgeSet{0});
    for (std::size_t e = 0; e < edges_; ++e) sets[root(e)] |= single_bit(e);
    return sets;
  }

 private:
  std::size_t root(std::size_t edge) const {
    while (parent_[edge] != edge) edge = parent_[edge];
    return edge;
  }

  std::size_t edges_;
  std::array<std::uint8_t, most_biedges> parent_;
};

class SplitSearch {
 public:
  SplitSearch(const Bigraph& bigraph, StepsLeft& steps)
      : bigraph_(bigraph),
        all_(all_edges(bigraph)),
        ranks_{rank(bigraph, 0, all_), rank(bigraph, 1, all_)},
        steps_(steps) {
    first_with_ends_.fill(none);
  }

  std::vector<EdgeParts> run() {
    State start;
    shared_ = single_bit(edge_to_split_by());
    for (const int side : {0, 1})
      if (!give(start, shared_, side)) return {};
    search(start);
    return std::move(found_);
  }

 private:
  /// parts[side] is contracted on that side and deleted on the other.
  struct State {
    EdgeParts parts{};
    std::array<VertexClasses, 2> classes;
    std::array<int, 2> ranks{};

    EdgeSet decided() const { return parts[0] | parts[1]; }
  };

  static constexpr std::uint8_t none = 255;

  /// Of an edge's ends on one side after contractions: edges that are parallel have the same.
  std::size_t ends_number(const State& state, std::size_t e, int side) const {
    const auto [a, b] = bigraph_[e].ends[side];
    const auto [low, high] = std::minmax({state.classes[side][a], state.classes[side][b]});
    return static_cast<std::size_t>(low) * most_bigraph_vertices + high;
  }

  /// The one with most parallels on both sides together: it leaves least to choose.
  std::size_t edge_to_split_by() const {
    std::size_t best = 0;
    int most = -1;
    for (std::size_t e = 0; e < bigraph_.size(); ++e) {
      const int parallels = parallels_of(e, 0) + parallels_of(e, 1);
      if (parallels > most) best = e;
      most = std::max(most, parallels);
    }
    return best;
  }

  int parallels_of(std::size_t e, int side) const {
    const State start;
    int count = 0;
    for (std::size_t f = 0; f < bigraph_.size(); ++f)
      if (ends_number(start, e, side) == ends_number(start, f, side)) ++count;
    return count;
  }

  /// Gives them, and what they make a loop of. False where that is in the other part.
  bool give(State& state, EdgeSet edges, int side) const {
    VertexClasses& classes = state.classes[side];
    for (EdgeSet left = edges; left != 0; left &= left - 1)
      if (classes.join(bigraph_[first_place(left)].ends[side])) ++state.ranks[side];
    state.parts[side] |= edges;
    for (EdgeSet left = all_ & ~state.parts[side]; left != 0; left &= left - 1)
      if (classes.are_joined(bigraph_[first_place(left)].ends[side])) state.parts[side] |= left & -left;
    return (state.parts[0] & state.parts[1] & ~shared_) == 0;
  }

  bool has_possible_ranks(const State& state) const {
    const auto rest = [&](int side) {
      return ranks_[1 - side] - state.ranks[1 - side] + state.ranks[side] - std::popcount(state.parts[side]);
    };
    return rest(0) >= 0 && rest(1) >= 0;
  }

  /// Joins edges that are parallel on that side.
  void join_parallel(const State& state, int side, EdgeClasses& together) {
    const EdgeSet edges = all_ & ~shared_ & ~state.parts[side];
    for (EdgeSet left = edges; left != 0; left &= left - 1) {
      std::uint8_t& first = first_with_ends_[ends_number(state, first_place(left), side)];
      if (first == none)
        first = static_cast<std::uint8_t>(first_place(left));
      else
        together.join(first_place(left), first);
    }
    for (EdgeSet left = edges; left != 0; left &= left - 1)
      first_with_ends_[ends_number(state, first_place(left), side)] = none;
  }

  /// What is in a class with decided edges, by the part that it must go to, and the largest class without any.
  struct Classified {
    EdgeParts forced{};
    EdgeSet largest_open = 0;
  };

  /// Nothing where a class would have to go to both parts.
  std::optional<Classified> classified(const State& state) {
    EdgeClasses together(bigraph_.size());
    for (const int side : {0, 1}) join_parallel(state, side, together);
    const auto members = together.members();
    Classified result;
    for (std::size_t e = 0; e < bigraph_.size(); ++e) {
      const EdgeSet edges = members[e] & ~shared_, open = edges & ~state.decided();
      if (open == 0) {
        if ((edges & state.parts[0]) != 0 && (edges & state.parts[1]) != 0) return std::nullopt;
        continue;
      }
      if (open == edges) {
        if (std::popcount(open) > std::popcount(result.largest_open)) result.largest_open = open;
        continue;
      }
      const int side = (edges & state.parts[0]) != 0 ? 0 : 1;
      if ((edges & state.parts[1 - side]) != 0) return std::nullopt;
      result.forced[side] |= open;
    }
    return result;
  }

  /// Gives what must go to a part until nothing must. Returns the class to decide next, empty where all is
  /// decided; nothing where there is no way.
  std::optional<EdgeSet> settle(State& state) {
    while (has_possible_ranks(state)) {
      if (state.decided() == all_) return 0;
      const auto next = classified(state);
      if (!next) return std::nullopt;
      if (next->forced == EdgeParts{}) return next->largest_open;
      for (const int side : {0, 1})
        if (!give(state, next->forced[side], side)) return std::nullopt;
    }
    return std::nullopt;
  }

  void search(State state) {
    if (!steps_.take()) return;
    const auto next = settle(state);
    if (!next) return;
    if (*next == 0) {
      found_.push_back(state.parts);
      return;
    }
    for (const int side : {0, 1}) {
      State longer = state;
      if (give(longer, *next, side)) search(longer);
    }
  }

  const Bigraph& bigraph_;
  EdgeSet all_;
  EdgeSet shared_ = 0;
  std::array<int, 2> ranks_;
  StepsLeft& steps_;
  std::array<std::uint8_t, most_bigraph_vertices * most_bigraph_vertices> first_with_ends_;
  std::vector<EdgeParts> found_;
};

}  // namespace

std::vector<EdgeParts> possible_splits(const Bigraph& bigraph, StepsLeft& steps) {
  return SplitSearch(bigraph, steps).run();
}

}  // namespace gcs
