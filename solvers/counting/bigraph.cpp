#include "solvers/counting/bigraph.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "solvers/counting/bits.hpp"

namespace gcs {
namespace {

using Ends = std::array<std::uint8_t, 2>;

/// Colour refinement: after k rounds the colour of a vertex depends on what is within k edges of it, on both
/// sides, and on nothing else. Neither names nor orders enter.
class Colours {
 public:
  explicit Colours(const Bigraph& bigraph) {
    for (auto& side : vertex_) side.fill(1);
    for (int round = 0; round < rounds; ++round) refine(bigraph);
    swapped_ = side_colour(bigraph, 1) < side_colour(bigraph, 0);
  }

  /// The side that comes first.
  int first_side() const { return swapped_ ? 1 : 0; }
  std::uint64_t of(const Biedge& edge) const {
    return mixed_bits(3 * on_side(edge, first_side()) + on_side(edge, 1 - first_side()));
  }
  std::uint64_t of(int side, std::uint8_t vertex) const { return vertex_[side][vertex]; }

 private:
  using SideColours = std::array<std::uint64_t, most_bigraph_vertices>;
  static constexpr int rounds = 2;  // with more, no fewer bigraphs of 12 and 14 points were counted

  std::uint64_t on_side(const Biedge& edge, int side) const {
    const Ends& ends = edge.ends[side];
    return mixed_bits(mixed_bits(vertex_[side][ends[0]]) + mixed_bits(vertex_[side][ends[1]]));
  }

  std::uint64_t side_colour(const Bigraph& bigraph, int side) const {
    std::uint64_t sum = 0;
    for (const Biedge& edge : bigraph) sum += mixed_bits(3 * on_side(edge, side) + on_side(edge, 1 - side));
    return sum;
  }

  void refine(const Bigraph& bigraph) {
    std::array<SideColours, 2> next = vertex_;
    for (const Biedge& edge : bigraph)
      for (const int side : {0, 1}) {
        const std::uint64_t other_side = on_side(edge, 1 - side);
        const auto [a, b] = edge.ends[side];
        next[side][a] += mixed_bits(other_side + 3 * vertex_[side][b]);
        next[side][b] += mixed_bits(other_side + 3 * vertex_[side][a]);
      }
    for (auto& side : next)
      for (std::uint64_t& colour : side) colour = mixed_bits(colour);
    vertex_ = next;
  }

  std::array<SideColours, 2> vertex_{};
  bool swapped_ = false;
};

/// Names the vertices of one side 0, 1, … in the order in which they are met.
class Names {
 public:
  Names() { name_.fill(unnamed); }
  std::uint8_t operator()(std::uint8_t vertex) {
    if (name_[vertex] == unnamed) name_[vertex] = next_++;
    return name_[vertex];
  }

 private:
  static constexpr std::uint8_t unnamed = 255;
  std::array<std::uint8_t, most_bigraph_vertices> name_{};
  std::uint8_t next_ = 0;
};

Ends renamed(Ends ends, int side, const Colours& colours, Names& names) {
  if (colours.of(side, ends[1]) < colours.of(side, ends[0])) std::swap(ends[0], ends[1]);
  for (std::uint8_t& end : ends) end = names(end);
  return {std::min(ends[0], ends[1]), std::max(ends[0], ends[1])};
}

}  // namespace

VertexClasses::VertexClasses() { std::iota(label_.begin(), label_.end(), std::uint8_t{0}); }

bool VertexClasses::join(const Ends& ends) {
  const std::uint8_t kept = label_[ends[0]], replaced = label_[ends[1]];
  if (kept == replaced) return false;
  for (std::uint8_t& label : label_) label = label == replaced ? kept : label;
  return true;
}

int rank(const Bigraph& bigraph, int side, EdgeSet edges) {
  VertexClasses classes;
  int rank = 0;
  for (std::size_t e = 0; e < bigraph.size(); ++e)
    if ((edges >> e & 1) != 0 && classes.join(bigraph[e].ends[side])) ++rank;
  return rank;
}

EdgeSet all_edges(const Bigraph& bigraph) {
  return bigraph.empty() ? 0 : ~EdgeSet{0} >> (most_biedges - bigraph.size());
}

Bigraph contracted(const Bigraph& bigraph, int side, EdgeSet edges) {
  VertexClasses classes;
  for (std::size_t e = 0; e < bigraph.size(); ++e)
    if ((edges >> e & 1) != 0) classes.join(bigraph[e].ends[side]);
  Bigraph result;
  for (std::size_t e = 0; e < bigraph.size(); ++e) {
    if ((edges >> e & 1) != 0) continue;
    result.push_back(bigraph[e]);
    for (std::uint8_t& end : result.back().ends[side]) end = classes[end];
  }
  return result;
}

Bigraph canonical(const Bigraph& bigraph) {
  const Colours colours(bigraph);
  std::vector<std::pair<std::uint64_t, std::size_t>> order;
  for (std::size_t e = 0; e < bigraph.size(); ++e) order.emplace_back(colours.of(bigraph[e]), e);
  std::sort(order.begin(), order.end());
  std::array<Names, 2> names;
  Bigraph result;
  for (const auto& [colour, e] : order) {
    Biedge& edge = result.emplace_back();
    for (const int place : {0, 1}) {
      const int side = place == 0 ? colours.first_side() : 1 - colours.first_side();
      edge.ends[place] = renamed(bigraph[e].ends[side], side, colours, names[place]);
    }
  }
  return result;
}

}  // namespace gcs
