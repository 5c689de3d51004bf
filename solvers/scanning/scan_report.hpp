#pragma once
/// What a scan of a plan is asked for and what it reports, the same for every strategy that scans.

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/scanning/plan_scan.hpp"

namespace gcs {

/// The option `max_cells`.
std::vector<OptionSpec> scan_option_specs();
/// Throws OptionError.
std::int64_t read_max_cells(const OptionMap& options);

/// The solutions with the claim that they are all real ones. Where pieces are undecided the status says so
/// and the reason names the first; points of them that satisfy the constraints to rounding are reported too.
SolveReport scan_report(const Scene& scene, const ScanPlan& plan, const ScanOutcome& outcome);

}  // namespace gcs
