#pragma once
/// Whether the cells of a run agree on what they count.

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "harness/runs/run_file.hpp"

namespace gcs {

/// Counts on the path that the literature gives and that are not known to be wrong, by instance.
using ExpectedCounts = std::map<std::string, std::uint64_t>;

/// Fills in CellRecord::difference where the counts on the path disagree. The standard of an instance is what
/// its cells with default options found; these must agree with each other and with `expected`. Every other
/// cell must agree with the standard, or with `expected` where there is none; one that claims all real
/// solutions must have as many at least. A cell that is found wrong loses its times.
void note_differences(std::vector<CellRecord>& cells, const ExpectedCounts& expected);

}  // namespace gcs
