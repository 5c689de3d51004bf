#pragma once
/// Follows any number of paths on any number of threads and processes, with the same bits for each whatever the others are.

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "solvers/homotopies/leg_block.hpp"
#include "solvers/homotopies/leg_message.hpp"
#include "solvers/homotopies/leg_stream.hpp"
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
      : unknowns_(system.unknowns), threads_(setup.threads), journal_(setup.journal), crew_(setup.crew) {
    if (crew_ != nullptr)
      task_ = to_message({system, elimination, setup.options, setup.set, setup.threads, setup.all_wide});
    LaneTrackers trackers, wide_trackers;
    for (int i = 0; i < setup.threads; ++i) {
      wide_trackers.push_back(make_wide_tracker(setup.set, system, elimination, wide(setup.options)));
      trackers.push_back(setup.all_wide
                             ? make_wide_tracker(setup.set, system, elimination, wide(setup.options))
                             : make_lane_tracker(setup.set, system, elimination, setup.options));
    }
    stream_ = std::make_unique<LegStream>(unknowns_, std::move(trackers), std::move(wide_trackers));
  }

  /// One result for every leg, in their order. What doubles cannot follow is followed again, from its start,
  /// in arithmetic of twice the precision, and ends that doubles cannot settle are settled there. Returns
  /// early when `stopped()` says so; legs that were not followed then end as LegEnd::too_many at s = 0.
  /// `stopped` is called from any of the threads. Adds to `work`.
  std::vector<LegResult> follow(std::span<const Leg> legs, const std::function<bool()>& stopped,
                                WorkCounters& work);
  /// What follows them here. Precondition of a use: follow() is not under way.
  LegStream& stream() { return *stream_; }

 private:
  using Stopped = std::function<bool()>;

  /// Options for the arithmetic of twice the precision.
  static TrackingOptions wide(TrackingOptions options);
  FollowedLegs recall_or_follow(std::span<const Leg> legs, const Stopped& stopped);
  FollowedLegs follow_now(std::span<const Leg> legs, const Stopped& stopped);
  void follow_lost_again(std::span<const Leg> legs, const Stopped& stopped, FollowedLegs& followed);
  void settle_ends(std::span<const Leg> legs, const Stopped& stopped, FollowedLegs& followed);
  FollowedLegs follow_in(LegArithmetic arithmetic, std::span<const Leg> legs, const Stopped& stopped);
  FollowedLegs follow_here(LegArithmetic arithmetic, std::span<const Leg> legs, const Stopped& stopped);
  FollowedLegs follow_with_crew(LegArithmetic arithmetic, std::span<const Leg> legs, const Stopped& stopped);
  std::size_t legs_of_item(LegArithmetic arithmetic) const;

  int unknowns_;
  int threads_;
  std::unique_ptr<LegStream> stream_;
  Journal* journal_;
  Crew* crew_;
  std::string task_{};  ///< for the crew
};

}  // namespace gcs
