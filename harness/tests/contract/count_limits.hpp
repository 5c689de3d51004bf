#pragma once
/// Solutions found against theoretical counts.

#include "harness/tests/contract/strategy_contract.hpp"
#include "solvers/counting/theoretical_counts.hpp"

namespace gcs::contract {

/// `limit`: no more classes are reported, and no more are said to exist at generic lengths, than the exact
/// count or the bound allows; where the count is exact, the number at generic lengths is this one. `counts`
/// are those of the scene's problem. Holds for every claim, since classes on S are real ones.
Violations check_limits(const Scene& scene, const TheoreticalCounts& counts, const SolveReport& report);

/// More complex solutions than a test has time for; where no exact count is known, a trace test takes many
/// times the time of the search. Counts are known where no positions are given.
bool has_many_solutions(const Scene& scene);

}  // namespace gcs::contract
