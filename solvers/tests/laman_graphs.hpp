#pragma once
/// Laman graphs for tests of counting.

#include <vector>

#include "solvers/tests/sample_problems.hpp"

namespace gcs::samples {

/// One graph of every isomorphism class, by Henneberg's two steps from an edge. Slow beyond 7 points.
std::vector<Edges> all_laman_graphs(int points);

/// A graph with the largest number of realisations among those with as many points.
struct RecordGraph {
  int points;
  std::uint64_t code;  ///< the upper triangle of the adjacency matrix, row by row, as a binary number
  std::uint64_t realisations;
};

/// Capco, Gallet, Grasegger, Koutschan, Lubbes, Schicho 2018, table 1.
extern const std::vector<RecordGraph> record_graphs;

Edges decoded(const RecordGraph& graph);

}  // namespace gcs::samples
