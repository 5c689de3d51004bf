#pragma once
/// The summands of the recursion over bigraphs that can be other than 0.

#include <array>
#include <vector>

#include "solvers/counting/bigraph.hpp"
#include "solvers/counting/recursion_limits.hpp"

namespace gcs {

/// M and N.
using EdgeParts = std::array<EdgeSet, 2>;

/// Pairs of edge sets (M, N) with M ∪ N = E, M ∩ N = {e} for one edge e of its choice, each once: all for which ᴹB and Bᴺ
/// have no loop and rank G + rank H = |E| + 1 where they have edges, and some whose summand is 0. Takes a step for
/// every decision and gives up, with what it has, when they are exceeded. Precondition: no bridge, no loop.
std::vector<EdgeParts> possible_splits(const Bigraph& bigraph, StepsLeft& steps);

}  // namespace gcs
