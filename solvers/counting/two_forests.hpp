#pragma once
/// Which sets of edges are independent: forests on both sides of a bigraph, and circuits in them.

#include <vector>

#include "solvers/counting/bigraph.hpp"

namespace gcs {

/// Of each edge the edges outside a spanning forest of that side whose circuits with the forest contain it: none
/// for a bridge, the same for edges that are in series (a cut of two edges). Precondition: no loop on that side.
std::vector<EdgeSet> circuits_through_edges(const Bigraph& bigraph, int side);

/// Whether the map (x, y) ↦ (x_e·y_e) of these edges has a dense image: whether rank_G(F) + rank_H(F) ≥ |F| + 1 for
/// every F ≠ ∅ of them. The rows of its Jacobian, (y_e·a_e, x_e·b_e) with incidence rows a_e of G and b_e of H, are
/// where the lines through (a_e, 0) and (0, b_e) meet the hyperplane of normal (x, −y), which is generic, and by
/// Lovász (Flats in matroids and geometric graphs, 1977) these points are independent under that condition alone.
/// It says that the edges, each of them doubled in turn, are a forest of G and one of H together (Edmonds 1968).
bool is_independent(const Bigraph& bigraph);

}  // namespace gcs
