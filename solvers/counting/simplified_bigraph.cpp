#include "solvers/counting/simplified_bigraph.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

#include "solvers/counting/bits.hpp"
#include "solvers/counting/two_forests.hpp"

namespace gcs {
namespace {

using BiedgeEnds = std::array<std::uint8_t, 2>;

bool are_parallel(const BiedgeEnds& a, const BiedgeEnds& b) {
  return std::minmax(a[0], a[1]) == std::minmax(b[0], b[1]);
}

Bigraph without_edges(const Bigraph& bigraph, EdgeSet edges) {
  Bigraph rest;
  for (std::size_t e = 0; e < bigraph.size(); ++e)
    if ((edges >> e & 1) == 0) rest.push_back(bigraph[e]);
  return rest;
}

using Circuits = std::array<std::vector<EdgeSet>, 2>;  ///< of each side, see circuits_through_edges

/// All that are a bridge on one side, but one that is left when they are all.
EdgeSet bridges(const Circuits& circuits) {
  const std::size_t edges = circuits[0].size();
  EdgeSet found = 0;
  for (std::size_t e = 0; e < edges; ++e)
    if (circuits[0][e] == 0 || circuits[1][e] == 0) found |= single_bit(e);
  return std::popcount(found) == static_cast<int>(edges) ? found & (found - 1) : found;
}

/// An edge that is parallel to another one on this side and in series with it on the other side.
std::optional<std::size_t> mergeable_edge(const Bigraph& bigraph, const Circuits& circuits, int side) {
  for (std::size_t e = 0; e < bigraph.size(); ++e)
    for (std::size_t f = 0; f < e; ++f)
      if (circuits[1 - side][e] == circuits[1 - side][f] &&
          are_parallel(bigraph[e].ends[side], bigraph[f].ends[side]))
        return e;
  return std::nullopt;
}

/// One step of it; nothing where no edge can be left out.
std::optional<Bigraph> with_less_edges(const Bigraph& bigraph) {
  if (bigraph.size() == 1) return std::nullopt;
  const Circuits circuits{circuits_through_edges(bigraph, 0), circuits_through_edges(bigraph, 1)};
  if (const EdgeSet found = bridges(circuits); found != 0) return without_edges(bigraph, found);
  for (const int side : {0, 1})
    if (const auto edge = mergeable_edge(bigraph, circuits, side))
      return contracted(bigraph, 1 - side, single_bit(*edge));
  return std::nullopt;
}

}  // namespace

std::optional<Bigraph> simplified(Bigraph bigraph) {
  const EdgeSet all = all_edges(bigraph);
  if (rank(bigraph, 0, all) + rank(bigraph, 1, all) != static_cast<int>(bigraph.size()) + 1 ||
      !is_independent(bigraph))
    return std::nullopt;
  while (auto smaller = with_less_edges(bigraph)) bigraph = std::move(*smaller);
  return bigraph;
}

}  // namespace gcs
