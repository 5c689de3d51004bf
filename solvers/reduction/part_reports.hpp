#pragma once
/// What reports on the parts of a scene have in common.

#include <vector>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Adds the particulars of the same name.
void add(const std::vector<Particular>& more, std::vector<Particular>& particulars);

bool claims_all(Claim claim);

/// `is_empty`: one of them proves that there is no solution.
SolveStatus common_status(const std::vector<SolveReport>& reports, bool is_empty);

/// The weakest of the claims.
Claim common_claim(const std::vector<SolveReport>& reports);

}  // namespace gcs
