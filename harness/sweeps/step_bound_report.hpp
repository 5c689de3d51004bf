#pragma once
/// The results of a sweep over random scenes as a Markdown page.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "harness/sweeps/random_scenes.hpp"
#include "harness/sweeps/step_bound_check.hpp"

namespace gcs {

struct SweptScene {
  std::uint64_t seed = 0;
  SceneKind kind;
  StepBoundVerdict verdict;
};

/// What was swept.
struct SweepHeader {
  std::vector<StepBound> bounds;
  std::uint64_t first_seed = 1;
  double total_s = 0;  ///< wall time of the sweep
};

/// One row per kind of scene, then every scene that does not agree, with the differences and reasons.
std::string step_bound_report(const SweepHeader& header, std::span<const SweptScene> scenes);

}  // namespace gcs
