#pragma once
/// Follows what another process sends.

#include <memory>
#include <string>

#include "solvers/running/crew.hpp"

namespace gcs {

/// The other side of LegTracking with a crew. Results have the same bits wherever they are followed: instructions that this
/// machine does not have are replaced. Throws std::invalid_argument for bytes that are none, and so do items.
std::unique_ptr<ItemWork> begin_legs(const std::string& task);

}  // namespace gcs
