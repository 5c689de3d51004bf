#pragma once
/// Results of followed legs as a block of a journal.

#include <span>
#include <vector>

#include "solvers/lanes/lane_tracker.hpp"
#include "solvers/running/journal.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

struct LegResult {
  LegState state;
  ComplexVectorX x;  ///< at state.s
};

/// Steps of legs that were followed, those of repetitions included.
struct LegWork {
  std::int64_t accepted = 0;
  std::int64_t rejected = 0;
  std::int64_t evaluations = 0;  ///< of a system, each with its Jacobian, a factorisation and a correction

  LegWork& operator+=(const LegWork& other);
  void add_to(WorkCounters& work) const;
};

/// Some legs' results, in the legs' order, and what they took.
struct FollowedLegs {
  std::vector<LegResult> results;
  LegWork work;
};

/// Precondition: every leg was followed to its end.
Journal::Block to_block(const FollowedLegs& followed);
/// The inverse. Throws std::invalid_argument for a block that is none of legs.
FollowedLegs from_block(const Journal::Block& block);

/// Of the starts, routes and limits of legs of a system of so many unknowns.
std::uint64_t fingerprint(std::span<const Leg> legs, int unknowns);

}  // namespace gcs
