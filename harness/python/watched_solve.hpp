#pragma once
/// A solve, or a figure that is followed, for which Python waits: its lock is free meanwhile, and Ctrl-C is heard.

#include <pybind11/pybind11.h>

#include <optional>
#include <vector>

#include "solvers/solving/follow.hpp"
#include "solvers/solving/solve.hpp"

namespace gcs {

/// Solves in a thread of its own while this one, which holds Python's lock, waits without it. `progress` is None or is
/// called now and then with the stage in words and the fraction done, negative where nobody can know. Ctrl-C and the time
/// limit, in seconds, stop the solve; the answer then holds what is there, with the status `interrupted` or `timed out`.
/// What `progress` or another handler of signals throws stops the solve and is thrown again. Throws what solve throws.
Answer watched_solve(const Scene& scene, const std::string& strategy, const OptionMap& options,
                     const SolveSettings& settings, std::optional<double> time_limit_s,
                     const pybind11::object& progress);

/// Follows in the same way; stopped, the last leg says so.
std::vector<Followed> watched_follow(const Scene& scene, const Figure& from,
                                     const std::vector<ChangedValues>& vertices,
                                     const FollowSettings& settings, std::optional<double> time_limit_s);

}  // namespace gcs
