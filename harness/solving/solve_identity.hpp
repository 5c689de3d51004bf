#pragma once
/// What makes two solves the same computation.

#include "harness/base/environment.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// All that the steps of a solve depend on, for the header of its journal: the program, the instance, the
/// strategy, those of its `options` (all of them, as complete_options gives them) that change its result, and
/// the seed. Threads are not among them.
JsonValue solve_identity(const Instance& instance, const StrategyEntry& entry, const OptionMap& options,
                         std::uint64_t seed, const Environment& environment);

}  // namespace gcs
