#pragma once
/// The graphs of the families of minimally rigid graphs.

#include <cstdint>
#include <optional>
#include <string>

#include "solvers/counting/realisation_count.hpp"

namespace gcs {

/// What the scene of a member is made of.
struct GraphMember {
  int points = 0;
  GraphEdges edges;
  bool is_on_sphere = false;  ///< a cone in space: all points at the distance 1 from a further one
};

/// The member of that id, nothing where it is of another family or of none.
std::optional<GraphMember> graph_member(const std::string& id);

}  // namespace gcs
