#pragma once
/// Keeps the lanes of trackers full with the legs of one list after another: lanes that the last legs of a list leave empty
/// take the first ones of the next. What doubles lose, or arrive at without settling it, goes on from there in arithmetic of
/// twice the precision; where its place there does not tell the path, it is followed there from its start, at last with
/// pivots that are large where it was lost: one order of elimination serves all paths, and some come where a pivot all but
/// vanishes.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "solvers/homotopies/leg_block.hpp"
#include "solvers/homotopies/leg_message.hpp"
#include "solvers/running/crew.hpp"
#include "solvers/running/run_on_threads.hpp"

namespace gcs {

/// One for each thread.
using LaneTrackers = std::vector<std::unique_ptr<LaneTracker>>;

/// What becomes of a leg with another order of elimination, after it was `lost`; nothing once `gives_up` says so.
using FollowReordered = std::function<std::optional<LegResult>(const Leg& leg, const LegResult& lost,
                                                               const std::atomic<bool>& gives_up)>;

struct FollowedList {
  std::uint64_t number = 0;
  FollowedLegs legs;
};

/// Of the path that the lane held last.
LegResult result_of(const LaneTracker& tracker, int lane, int unknowns);

/// The caller's thread follows legs in advance() alone, the others whenever there are any.
class LegStream {
 public:
  /// As many of the one kind as of the other, one of each for the caller's thread.
  LegStream(int unknowns, LaneTrackers trackers, LaneTrackers wide_trackers,
            FollowReordered follow_reordered);
  ~LegStream() { give_up(); }
  LegStream(const LegStream&) = delete;
  LegStream& operator=(const LegStream&) = delete;

  /// What `legs`, which begin at s = 0, refer to stays until they are followed or given up.
  void add(std::uint64_t number, std::vector<Leg> legs);
  bool is_idle() const { return lists_.empty(); }
  /// A few steps of the caller's trackers, or a short wait for the others where these have no legs; the lists that are done
  /// then.
  std::vector<FollowedList> advance();
  /// The lists that are not done, as far as they are: legs that were not followed end as LegEnd::too_many at s = 0.
  std::vector<FollowedList> give_up();

 private:
  /// How a leg is followed next; a leg takes the ways in this order, and may leave out the last ones.
  enum class Way { doubles, wide_from_there, wide_from_start, reordered, done };
  struct List {
    List(std::uint64_t its_number, std::vector<Leg> its_legs);

    std::uint64_t number = 0;
    std::vector<Leg> legs;
    std::vector<LegResult> results;
    std::vector<Way> ways;
    LegWork work;
    std::size_t open = 0;  ///< legs
  };
  /// A leg in a lane; none where the list is null.
  struct Place {
    List* list = nullptr;
    std::size_t leg = 0;
  };
  struct Lanes {
    std::unique_ptr<LaneTracker> tracker;
    std::vector<Place> places;

    explicit Lanes(std::unique_ptr<LaneTracker> made);
    bool is_busy() const;
  };
  /// What one thread has.
  struct Feeder {
    Lanes doubles, wide;
    bool is_at_work = false;  ///< in the background
  };
  /// Legs that are in no lane.
  struct Waiting {
    std::deque<Place> places;
    std::atomic<std::size_t> count = 0;  ///< of them, for a look without a lock
  };

  void call_others();
  void work(Feeder& feeder);
  int step(Feeder& feeder);
  bool refill(Lanes& lanes, Waiting& waiting);
  Place next_leg(Waiting& waiting);
  void step(Lanes& lanes);
  void take_result(Lanes& lanes, int lane);
  static LegWork keep(Place place, LegResult result);
  void put(Waiting& waiting, Place place);
  static Way next_way(Way way, const LegResult& result);
  static Leg leg_of(Place place);
  std::vector<FollowedList> done_lists();

  int unknowns_;
  FollowReordered follow_reordered_;
  std::vector<Feeder> feeders_;
  Waiting waiting_, waiting_wide_;
  std::atomic<std::size_t> done_ = 0;  // lists
  std::atomic<bool> gives_up_ = false;
  std::mutex mutex_;  // of the lists and what they say of their legs, and of who is at work
  std::condition_variable list_done_;
  std::deque<std::unique_ptr<List>> lists_;
  std::exception_ptr failure_;
  Background others_;
};

/// A stream's lists as items, whose bytes are those of leg_message.hpp.
class LegItems final : public ItemWork {
 public:
  explicit LegItems(std::shared_ptr<LegStream> stream) : stream_(std::move(stream)) {}
  /// Leaves nothing in the stream.
  ~LegItems() override { stream_->give_up(); }
  LegItems(const LegItems&) = delete;
  LegItems& operator=(const LegItems&) = delete;

  void add(NumberedItem item) override;
  /// As long as the process that hands them out sorts in what came back, and looks for no messages: tens of milliseconds.
  std::size_t reserve() const override { return 64; }
  bool is_idle() const override { return stream_->is_idle(); }
  std::vector<NumberedItem> advance() override;

 private:
  std::shared_ptr<LegStream> stream_;
  std::map<std::uint64_t, SentLegs> sent_;
};

}  // namespace gcs
