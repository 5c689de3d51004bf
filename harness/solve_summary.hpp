#pragma once
/// A solve's result for a person.

#include <string>
#include <string_view>

#include "harness/instance_io.hpp"
#include "harness/solve_run.hpp"

namespace gcs {

/// One indented line: a label and what it says.
std::string summary_line(std::string_view label, std::string_view text);

/// Status, counts with their convention, the crossings in the order met on the path, the range of residuals
/// and condition numbers, work and time. Ends in a newline.
std::string solve_summary(const Instance& instance, const SolveRun& run);

}  // namespace gcs
