#pragma once
/// Laman graphs of the literature.

#include <cstdint>
#include <vector>

namespace gcs::samples {

/// A graph with the largest number of realisations among those with as many points.
struct RecordGraph {
  int points;
  std::uint64_t code;  ///< see graph_of_code
  std::uint64_t realisations;
};

/// Capco, Gallet, Grasegger, Koutschan, Lubbes, Schicho 2018, table 1.
extern const std::vector<RecordGraph> record_graphs;

}  // namespace gcs::samples
