#include "solvers/counting/two_forests.hpp"

#include <array>
#include <optional>
#include <utility>

#include "solvers/counting/bits.hpp"

namespace gcs {
namespace {

/// A forest of one side.
class Forest {
 public:
  Forest(const Bigraph& bigraph, int side) : bigraph_(bigraph), side_(side) {}

  bool contains(std::size_t edge) const { return (edges_ & single_bit(edge)) != 0; }
  EdgeSet edges() const { return edges_; }

  /// Precondition: the edges are a forest.
  void set(EdgeSet edges) {
    edges_ = edges;
    tree_.fill(no_tree);
    for (EdgeSet left = edges; left != 0;) left &= ~grow(bigraph_[first_place(left)].ends[side_][0], left);
  }

  /// The edges of the forest that close a circuit with an edge outside it; nothing where none does.
  std::optional<EdgeSet> circuit_with(std::size_t edge) const {
    const auto [a, b] = bigraph_[edge].ends[side_];
    if (a == b) return 0;
    if (tree_[a] == no_tree || tree_[a] != tree_[b]) return std::nullopt;
    return path_[a] ^ path_[b];
  }

 private:
  static constexpr std::uint8_t no_tree = 255;

  /// Finds the paths from the root to all vertices of its tree, of which these edges are not yet used. Returns the
  /// tree's.
  EdgeSet grow(std::uint8_t root, EdgeSet edges) {
    tree_[root] = root;
    path_[root] = 0;
    EdgeSet grown = 0;
    for (bool grows = true; grows;) {
      grows = false;
      for (EdgeSet left = edges & ~grown; left != 0; left &= left - 1) {
        const std::size_t edge = first_place(left);
        auto [near, far] = bigraph_[edge].ends[side_];
        if (tree_[near] != root) std::swap(near, far);
        if (tree_[near] != root) continue;
        tree_[far] = root;
        path_[far] = path_[near] | single_bit(edge);
        grown |= single_bit(edge);
        grows = true;
      }
    }
    return grown;
  }

  const Bigraph& bigraph_;
  int side_;
  EdgeSet edges_ = 0;
  std::array<std::uint8_t, most_bigraph_vertices> tree_{};
  std::array<EdgeSet, most_bigraph_vertices> path_{};
};

/// A forest of each side, without an edge in common.
class TwoForests {
 public:
  explicit TwoForests(const Bigraph& bigraph) : forests_{Forest(bigraph, 0), Forest(bigraph, 1)} {
    for (Forest& forest : forests_) forest.set(0);
  }

  /// Adds an edge and moves others from forest to forest to make room. False where that is impossible.
  bool add(std::size_t edge) {
    std::vector<Step> steps{{edge, 0}};
    EdgeSet seen = single_bit(edge);
    for (std::size_t i = 0; i < steps.size(); ++i)
      for (const int side : {0, 1}) {
        if (forests_[side].contains(steps[i].edge)) continue;
        const auto circuit = forests_[side].circuit_with(steps[i].edge);
        if (!circuit) {
          move_along(steps, i, side);
          return true;
        }
        for (EdgeSet next = *circuit & ~seen; next != 0; next &= next - 1)
          steps.push_back({first_place(next), i});
        seen |= *circuit;
      }
    return false;
  }

  /// Whether any one edge could be there twice.
  bool has_room_for_each() const {
    EdgeSet without = forests_[0].edges() | forests_[1].edges();
    for (bool changes = true; changes;) {
      changes = false;
      for (EdgeSet left = without; left != 0; left &= left - 1)
        if (makes_room(first_place(left), without)) {
          without &= ~single_bit(first_place(left));
          changes = true;
        }
    }
    return without == 0;
  }

 private:
  /// An edge that would take the place of the one at step `from`.
  struct Step {
    std::size_t edge;
    std::size_t from;
  };

  void move_along(const std::vector<Step>& steps, std::size_t last, int side) {
    std::array<EdgeSet, 2> edges{forests_[0].edges(), forests_[1].edges()};
    for (std::size_t i = last;; i = steps[i].from, side = 1 - side) {
      edges[1 - side] &= ~single_bit(steps[i].edge);
      edges[side] |= single_bit(steps[i].edge);
      if (i == 0) break;
    }
    for (const int each : {0, 1}) forests_[each].set(edges[each]);
  }

  /// Whether a copy of an edge fits into the forest that does not hold it, or replaces an edge there that has room.
  bool makes_room(std::size_t edge, EdgeSet without_room) const {
    const Forest& other = forests_[forests_[0].contains(edge) ? 1 : 0];
    const auto circuit = other.circuit_with(edge);
    return !circuit || (*circuit & ~without_room) != 0;
  }

  std::array<Forest, 2> forests_;
};

EdgeSet spanning_forest(const Bigraph& bigraph, int side) {
  VertexClasses classes;
  EdgeSet forest = 0;
  for (std::size_t e = 0; e < bigraph.size(); ++e)
    if (classes.join(bigraph[e].ends[side])) forest |= single_bit(e);
  return forest;
}

}  // namespace

std::vector<EdgeSet> circuits_through_edges(const Bigraph& bigraph, int side) {
  Forest forest(bigraph, side);
  forest.set(spanning_forest(bigraph, side));
  std::vector<EdgeSet> through(bigraph.size(), 0);
  for (std::size_t e = 0; e < bigraph.size(); ++e) {
    if (forest.contains(e)) continue;
    through[e] = single_bit(e);
    for (EdgeSet circuit = *forest.circuit_with(e); circuit != 0; circuit &= circuit - 1)
      through[first_place(circuit)] |= single_bit(e);
  }
  return through;
}

bool is_independent(const Bigraph& bigraph) {
  TwoForests forests(bigraph);
  for (std::size_t e = 0; e < bigraph.size(); ++e)
    if (!forests.add(e)) return false;
  return forests.has_room_for_each();
}

}  // namespace gcs
