#pragma once
/// Follows any number of paths on any number of threads and processes, with the same bits for each whatever the others are.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "solvers/homotopies/leg_block.hpp"
#include "solvers/homotopies/leg_message.hpp"
#include "solvers/lanes/lane_trackers.hpp"
#include "solvers/running/crew.hpp"

namespace gcs {

/// How paths are followed, and on how many threads.
struct TrackingSetup {
  TrackingOptions options;
  InstructionSet set = InstructionSet::portable;
  int threads = 1;             ///< ≥ 1
  Journal* journal = nullptr;  ///< what it has recorded is not followed again
  bool all_wide = false;       ///< everything in twice the precision, not only what doubles cannot follow
  Crew* crew = nullptr;        ///< other processes that follow some
};

/// Follows legs of one system.
class LegTracking {
 public:
  /// `system`, of squares or of monomials, `elimination` and the journal are referred to.
  template <class System>
  LegTracking(const System& system, const Elimination& elimination, const TrackingSetup& setup)
      : unknowns_(system.unknowns), journal_(setup.journal), crew_(setup.crew) {
    if (crew_ != nullptr)
      task_ = to_message({system, elimination, setup.options, setup.set, setup.threads, setup.all_wide});
    for (int i = 0; i < setup.threads; ++i) {
      wide_trackers_.push_back(make_wide_tracker(setup.set, system, elimination, wide(setup.options)));
      trackers_.push_back(setup.all_wide
                              ? make_wide_tracker(setup.set, system, elimination, wide(setup.options))
                              : make_lane_tracker(setup.set, system, elimination, setup.options));
    }
  }

  /// One result for every leg, in their order. What doubles cannot follow is followed again, from its start,
  /// in arithmetic of twice the precision, and ends that doubles cannot settle are settled there. Returns
  /// early when `stopped()` says so; legs that were not followed then end as LegEnd::too_many at s = 0.
  /// `stopped` is called from any of the threads. Adds to `work`.
  std::vector<LegResult> follow(std::span<const Leg> legs, const std::function<bool()>& stopped,
                                WorkCounters& work);
  /// The same on this process alone and without a journal, in one go.
  FollowedLegs follow_here(std::span<const Leg> legs, const std::function<bool()>& stopped);

 private:
  using Trackers = std::vector<std::unique_ptr<LaneTracker>>;  // one per thread

  /// Options for the arithmetic of twice the precision.
  static TrackingOptions wide(TrackingOptions options);
  FollowedLegs recall_or_follow(std::span<const Leg> legs, const std::function<bool()>& stopped);
  FollowedLegs follow_now(std::span<const Leg> legs, const std::function<bool()>& stopped);
  FollowedLegs follow_with_crew(std::span<const Leg> legs, const std::function<bool()>& stopped);
  std::vector<LegResult> follow_with(Trackers& trackers, std::span<const Leg> legs,
                                     const std::function<bool()>& stopped, LegWork& work) const;
  void follow_lost_again(std::span<const Leg> legs, const std::function<bool()>& stopped,
                         FollowedLegs& followed);
  void settle_ends(std::span<const Leg> legs, const std::function<bool()>& stopped, FollowedLegs& followed);

  int unknowns_;
  Trackers trackers_;
  Trackers wide_trackers_;
  Journal* journal_;
  Crew* crew_;
  std::string task_{};  ///< for the crew
};

}  // namespace gcs
