#pragma once
/// Bigraphs with less edges and as many realisations.

#include <optional>

#include "solvers/counting/bigraph.hpp"

namespace gcs {

/// A bigraph with as many realisations in which no edge can be left out, or a single edge; nothing where there are
/// none, because the map of bigraph_count.hpp is not dominant. Precondition: not empty.
/// A bridge e of G alone can go: x_e is free, and x_e·y_e = λ_e determines it. Where e and f are parallel in G and in
/// series in H, f can be deleted in G and contracted in H: with x = x_e = ±x_f all other equations know y_e and y_f by
/// their sum z alone, for which x·z = λ_e ± λ_f, and λ_e = x·y_e determines them.
std::optional<Bigraph> simplified(Bigraph bigraph);

}  // namespace gcs
