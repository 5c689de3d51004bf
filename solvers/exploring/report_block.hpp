#pragma once
/// What exploring finds as blocks of a journal.

#include <vector>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Of each report its status and reason, real candidates, paths without plans, curves, work and particulars, to the bit.
Journal::Block to_block(const std::vector<SolveReport>& reports);
/// The inverse. Throws std::invalid_argument for a block that is none of reports.
std::vector<SolveReport> reports_from(const Journal::Block& block);

}  // namespace gcs
