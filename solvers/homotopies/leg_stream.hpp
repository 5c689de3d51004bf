#pragma once
/// Keeps the lanes of trackers full with the legs of one list after another: lanes that the last legs of a list leave empty
/// take the first ones of the next.

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "solvers/homotopies/leg_block.hpp"
#include "solvers/homotopies/leg_message.hpp"
#include "solvers/running/crew.hpp"

namespace gcs {

/// One for each thread.
using LaneTrackers = std::vector<std::unique_ptr<LaneTracker>>;

struct FollowedList {
  std::uint64_t number = 0;
  FollowedLegs legs;
};

class LegStream {
 public:
  /// As many of the one kind as of the other.
  LegStream(int unknowns, LaneTrackers trackers, LaneTrackers wide_trackers);

  /// What `legs` refer to stays until they are followed or given up.
  void add(std::uint64_t number, std::vector<Leg> legs, LegArithmetic arithmetic);
  bool is_idle() const { return lists_.empty(); }
  /// So many steps of every tracker at most; the lists that are done then. `stopped` is called from any of the threads.
  std::vector<FollowedList> advance(std::int64_t most_steps, const std::function<bool()>& stopped);
  /// The lists that are not done, as far as they are: legs that were not followed end as LegEnd::too_many at s = 0.
  std::vector<FollowedList> give_up();

 private:
  struct List {
    std::uint64_t number = 0;
    LegArithmetic arithmetic = LegArithmetic::doubles;
    std::vector<Leg> legs;
    std::vector<LegResult> results;
    std::size_t next = 0;  ///< leg to follow
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
    bool are_busy() const;
  };
  /// What one thread has.
  struct Feeder {
    Lanes doubles, wide;
  };

  std::vector<Feeder*> needed_feeders();
  void feed(Feeder& feeder, std::int64_t most_steps, const std::function<bool()>& stopped);
  bool refill(Lanes& lanes, LegArithmetic arithmetic);
  Place next_leg(LegArithmetic arithmetic);
  void step(Lanes& lanes);
  void take_result(Lanes& lanes, int lane);
  std::atomic<std::size_t>& waiting(LegArithmetic arithmetic);

  int unknowns_;
  std::vector<Feeder> feeders_;
  std::deque<std::unique_ptr<List>> lists_;
  std::atomic<std::size_t> waiting_ = 0, waiting_wide_ = 0;  // legs that are in no lane
  std::mutex mutex_;                                         // of what lists say of their legs
};

/// A stream's lists as items, whose bytes are those of leg_message.hpp.
class LegItems final : public ItemWork {
 public:
  explicit LegItems(LegStream& stream) : stream_(stream) {}
  /// Leaves nothing in the stream.
  ~LegItems() override { stream_.give_up(); }
  LegItems(const LegItems&) = delete;
  LegItems& operator=(const LegItems&) = delete;

  void add(NumberedItem item) override;
  /// Lanes that the last legs of an item leave empty have others before the next look for messages.
  std::size_t reserve() const override { return 2; }
  bool is_idle() const override { return stream_.is_idle(); }
  std::vector<NumberedItem> advance() override;

 private:
  LegStream& stream_;
  std::map<std::uint64_t, SentLegs> sent_;
};

}  // namespace gcs
