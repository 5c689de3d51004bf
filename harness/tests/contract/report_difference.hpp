#pragma once
/// Whether two reports are the same bit for bit.

#include <optional>
#include <string>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs::contract {

/// The first field in which the reports differ ("candidates[3].points"), or nothing. Every field takes part,
/// numbers by their bits.
std::optional<std::string> first_difference(const SolveReport& a, const SolveReport& b);

}  // namespace gcs::contract
