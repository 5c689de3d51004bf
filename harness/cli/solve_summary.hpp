#pragma once
/// A solve's result for a person.

#include <string>
#include <string_view>

#include "harness/instances/instance_lookup.hpp"
#include "harness/solving/solve_run.hpp"

namespace gcs {

/// Status, counts with their convention, the crossings in the order met on the path, the range of residuals
/// and condition numbers, work and time. Ends in a newline.
std::string solve_summary(const Instance& instance, const SolveRun& run);

}  // namespace gcs
