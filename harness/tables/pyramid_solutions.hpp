#pragma once
/// The solutions of 5p1L that a run holds, as Hoffmann and Yuan list them.

#include <vector>

#include "harness/runs/run_file.hpp"

namespace gcs {

/// The instance that the paper's Table 1 is.
inline constexpr const char* pyramid_instance = "hoffmann-yuan";

/// Of the right answers on the instance the one with the most solutions, or nullptr.
const CellRecord* richest_cell(const RunFile& run, const std::string& instance);

/// The real solutions of the cell in the 'fixed frame', mirror images x → −x and y → −y apart; none when
/// there is no cell.
std::vector<RecordedSolution> fixed_frame_solutions(const CellRecord* cell);

}  // namespace gcs
