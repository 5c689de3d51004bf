#pragma once
/// What a scan of a plan reports, the same for every strategy that scans.

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/scanning/scan_outcome.hpp"

namespace gcs {

/// `angles`: of the plan. The solutions with the claim that they are all real ones. Where pieces are undecided the status says so
/// and the reason names the first; points of them that satisfy the constraints to rounding are reported too.
SolveReport scan_report(const Scene& scene, std::size_t angles, const ScanOutcome& outcome);

}  // namespace gcs
