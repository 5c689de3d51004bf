#pragma once
/// Follows any number of paths on any number of threads and processes, with the same bits for each whatever the others are.

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
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

/// How paths are followed, and on how many threads of this process and those of the crew on this machine.
struct TrackingSetup {
  TrackingOptions options;
  InstructionSet set = InstructionSet::portable;
  int threads = 1;  ///< ≥ 1
  /// What it has recorded is not followed again; after a step that it does not have it has none.
  Journal* journal = nullptr;
  bool all_wide = false;  ///< everything in twice the precision, not only what doubles cannot follow
  Crew* crew = nullptr;   ///< other processes that follow some
};

/// Options for the arithmetic of twice the precision.
TrackingOptions wide(TrackingOptions options);

/// See FollowReordered.
template <class System>
std::optional<LegResult> follow_reordered(const System& system, const TrackingSetup& setup, const Leg& leg,
                                          const LegResult& lost, const std::atomic<bool>& gives_up) {
  const Elimination elimination =
      order_elimination_at(system, parameters_at(*leg.route, lost.state.s), lost.x);
  const auto tracker = make_wide_tracker(setup.set, system, elimination, wide(setup.options));
  tracker->load(0, leg);
  while (tracker->is_busy(0)) {
    if (gives_up) return std::nullopt;
    tracker->step();
  }
  return result_of(*tracker, 0, system.unknowns);
}

/// Follows legs of `system`, of squares or of monomials; it and `elimination` are referred to.
template <class System>
std::unique_ptr<LegStream> make_leg_stream(const System& system, const Elimination& elimination,
                                           const TrackingSetup& setup) {
  LaneTrackers trackers, wide_trackers;
  for (int i = 0; i < setup.threads; ++i) {
    wide_trackers.push_back(make_wide_tracker(setup.set, system, elimination, wide(setup.options)));
    trackers.push_back(setup.all_wide ? make_wide_tracker(setup.set, system, elimination, wide(setup.options))
                                      : make_lane_tracker(setup.set, system, elimination, setup.options));
  }
  const auto reordered = [&system, setup](const Leg& leg, const LegResult& lost,
                                          const std::atomic<bool>& gives_up) {
    return follow_reordered(system, setup, leg, lost, gives_up);
  };
  return std::make_unique<LegStream>(system.unknowns, std::move(trackers), std::move(wide_trackers),
                                     reordered);
}

/// Of a crew's member here, where there is a crew.
TrackingSetup of_member(TrackingSetup setup);

/// Follows legs of one system.
class LegTracking {
 public:
  /// `system`, of squares or of monomials, `elimination` and the journal are referred to.
  template <class System>
  LegTracking(const System& system, const Elimination& elimination, const TrackingSetup& setup)
      : unknowns_(system.unknowns),
        setup_(of_member(setup)),
        stream_(make_leg_stream(system, elimination, setup_)) {
    if (setup_.crew != nullptr)
      task_ = to_message({system, elimination, setup_.options, setup_.set, setup_.threads, setup_.all_wide});
  }

  /// Legs whose results take() returns. They are copied, and followed beside those that were added before and after.
  void add(std::span<const Leg> legs);
  /// One result for every leg of those that were added first, in their order. Once `stopped()` says so, all that
  /// was added is left where it is; legs that were not followed then end as LegEnd::too_many at s = 0. Adds to `work`.
  /// Precondition: some were added.
  std::vector<LegResult> take(const std::function<bool()>& stopped, WorkCounters& work);
  /// Leaves what was added and not taken.
  void give_up();
  /// The results of add() and take(), in parts. Precondition: nothing is added and not taken.
  std::vector<LegResult> follow(std::span<const Leg> legs, const std::function<bool()>& stopped,
                                WorkCounters& work);

 private:
  using Stopped = std::function<bool()>;

  /// Legs that were added together.
  struct Block {
    std::uint64_t last_piece = 0;  ///< pieces of older blocks have smaller numbers
    SentLegs sent;
    std::vector<Leg> legs;
    FollowedLegs followed;
    bool is_handed_in = false;
    std::size_t open = 0;  ///< legs that are not followed
  };
  /// A block's legs from this one on.
  struct Piece {
    Block* block = nullptr;
    std::size_t first = 0;
  };

  void recall_or_follow(Block& block, const Stopped& stopped);
  void follow(Block& block, const Stopped& stopped);
  void hand_in(Block& block);
  std::vector<FollowedList> advance();
  void sort_in(FollowedList list);
  void leave();
  void rest();
  std::size_t legs_of_piece() const;

  int unknowns_;
  TrackingSetup setup_;
  std::string task_{};  ///< for the crew
  std::deque<std::unique_ptr<Block>> blocks_;
  std::map<std::uint64_t, Piece> pieces_;  ///< that are followed, by the numbers of their lists
  std::uint64_t last_block_ = 0;
  std::shared_ptr<LegStream> stream_;
  // While the crew follows some.
  std::unique_ptr<LegItems> items_;  ///< of the stream
  std::unique_ptr<ItemWork> shared_;
};

}  // namespace gcs
