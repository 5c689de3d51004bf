#include "solvers/homotopies/leg_tracking.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <stdexcept>

#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// What is lost at most when a run is killed, and far more than all threads have in hand at once.
constexpr std::size_t legs_per_block = 4096;

/// Fewer are not worth a message: a tracker's lanes empty towards the end of a batch.
constexpr std::size_t fewest_in_batch = 64;

/// Large ones first, and of what is left so small ones that nobody is waited for long.
std::vector<std::span<const Leg>> batches_of(std::span<const Leg> legs, int members) {
  std::vector<std::span<const Leg>> batches;
  while (!legs.empty()) {
    const std::size_t share = legs.size() / (3 * static_cast<std::size_t>(members));
    const std::size_t size = std::min(legs.size(), std::max(share, fewest_in_batch));
    batches.push_back(legs.first(size));
    legs = legs.subspan(size);
  }
  return batches;
}

/// Keeps the lanes of one tracker full until no leg is left.
class LegFeeder {
 public:
  LegFeeder(LaneTracker& tracker, int unknowns, std::span<const Leg> legs, std::atomic<std::size_t>& next,
            std::vector<LegResult>& results)
      : tracker_(tracker),
        unknowns_(unknowns),
        legs_(legs),
        next_(next),
        results_(results),
        leg_in_(tracker.lanes(), none) {}

  void run(const std::function<bool()>& stopped) {
    while (refill() && !stopped()) {
      tracker_.step();
      for (int lane = 0; lane < tracker_.lanes(); ++lane)
        if (leg_in_[lane] != none && !tracker_.is_busy(lane)) take_result(lane);
    }
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// False when all lanes are empty.
  bool refill() {
    bool busy = false;
    for (int lane = 0; lane < tracker_.lanes(); ++lane) {
      if (leg_in_[lane] == none) load(lane);
      busy = busy || leg_in_[lane] != none;
    }
    return busy;
  }

  void load(int lane) {
    const std::size_t leg = next_.fetch_add(1);
    if (leg >= legs_.size()) return;
    leg_in_[lane] = leg;
    tracker_.load(lane, legs_[leg]);
  }

  void take_result(int lane) {
    LegResult& result = results_[leg_in_[lane]];
    result.state = tracker_.state(lane);
    result.x.resize(static_cast<std::size_t>(unknowns_));
    tracker_.read(lane, result.x.data());
    leg_in_[lane] = none;
  }

  LaneTracker& tracker_;
  int unknowns_;
  std::span<const Leg> legs_;
  std::atomic<std::size_t>& next_;
  std::vector<LegResult>& results_;
  std::vector<std::size_t> leg_in_;
};

bool is_lost(const LegResult& result) {
  return result.state.end == LegEnd::too_small || result.state.end == LegEnd::too_many;
}

/// The last correction of an end that Newton's method in doubles settles: its next one would be its square.
bool is_unsettled(const LegResult& result) {
  constexpr double settled = 1e-10;
  return result.state.end == LegEnd::arrived && result.state.last_correction > settled;
}

std::vector<std::size_t> places_of(const std::vector<LegResult>& results, bool (*wanted)(const LegResult&)) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < results.size(); ++i)
    if (wanted(results[i])) places.push_back(i);
  return places;
}

/// The parameters stay where the route ends.
Route standing(const Route& route) {
  const ComplexVectorX zero(route.end.size());
  return {{route.end, zero, zero, zero}, route.end};
}

void add_work(const std::vector<LegResult>& results, LegWork& work) {
  for (const LegResult& result : results) {
    work.accepted += result.state.steps - result.state.rejected;
    work.rejected += result.state.rejected;
    work.evaluations += result.state.steps + 2;  // with the start and the end
  }
}

}  // namespace

TrackingOptions LegTracking::wide(TrackingOptions options) {
  // Of twice the digits a prediction a hundred times as good needs few. A higher order would cost more than
  // the few steps that it saves.
  options.tolerance *= 1e-2;
  options.most_rejected = 200;  // nothing follows again what is lost here
  return options;
}

std::vector<LegResult> LegTracking::follow(std::span<const Leg> legs, const std::function<bool()>& stopped,
                                           WorkCounters& work) {
  std::vector<LegResult> results;
  for (std::size_t first = 0; first < legs.size(); first += legs_per_block) {
    const std::span<const Leg> some = legs.subspan(first, std::min(legs_per_block, legs.size() - first));
    // Once stopped, what is asked for next is no longer what an undisturbed run asks for.
    const bool use_journal = journal_ && !stopped();
    FollowedLegs followed = use_journal ? recall_or_follow(some, stopped) : follow_now(some, stopped);
    followed.work.add_to(work);
    std::move(followed.results.begin(), followed.results.end(), std::back_inserter(results));
  }
  return results;
}

FollowedLegs LegTracking::recall_or_follow(std::span<const Leg> legs, const std::function<bool()>& stopped) {
  FollowedLegs followed;
  const auto follow_all = [&]() -> std::optional<Journal::Block> {
    followed = follow_now(legs, stopped);
    if (stopped()) return std::nullopt;
    return to_block(followed);
  };
  const auto block = journal_->result(fingerprint(legs, unknowns_), follow_all);
  if (block) followed = from_block(*block);
  if (followed.results.size() != legs.size())
    throw std::invalid_argument("a journal's block has not as many paths as were to be followed");
  return followed;
}

FollowedLegs LegTracking::follow_now(std::span<const Leg> legs, const std::function<bool()>& stopped) {
  return crew_ != nullptr && legs.size() > fewest_in_batch ? follow_with_crew(legs, stopped)
                                                           : follow_here(legs, stopped);
}

FollowedLegs LegTracking::follow_with_crew(std::span<const Leg> legs, const std::function<bool()>& stopped) {
  const std::vector<std::span<const Leg>> batches = batches_of(legs, crew_->members());
  std::vector<std::string> items;
  for (const std::span<const Leg> batch : batches) items.push_back(to_message(batch, unknowns_));
  const auto here = [&](std::size_t i) { return to_message(follow_here(batches[i], stopped)); };
  const std::vector<std::string> results = crew_->results(task_, items, here, stopped);
  FollowedLegs followed;
  for (std::size_t i = 0; i < batches.size(); ++i) {
    FollowedLegs some;
    if (!results[i].empty()) some = read_followed(results[i]);
    some.results.resize(batches[i].size());
    followed.work.accepted += some.work.accepted;
    followed.work.rejected += some.work.rejected;
    followed.work.evaluations += some.work.evaluations;
    std::move(some.results.begin(), some.results.end(), std::back_inserter(followed.results));
  }
  return followed;
}

FollowedLegs LegTracking::follow_here(std::span<const Leg> legs, const std::function<bool()>& stopped) {
  FollowedLegs followed;
  followed.results = follow_with(trackers_, legs, stopped, followed.work);
  follow_lost_again(legs, stopped, followed);
  settle_ends(legs, stopped, followed);
  return followed;
}

void LegTracking::follow_lost_again(std::span<const Leg> legs, const std::function<bool()>& stopped,
                                    FollowedLegs& followed) {
  const std::vector<std::size_t> places = places_of(followed.results, is_lost);
  std::vector<Leg> lost;
  for (const std::size_t place : places) lost.push_back(legs[place]);
  std::vector<LegResult> again = follow_with(wide_trackers_, lost, stopped, followed.work);
  for (std::size_t i = 0; i < places.size(); ++i) followed.results[places[i]] = std::move(again[i]);
}

void LegTracking::settle_ends(std::span<const Leg> legs, const std::function<bool()>& stopped,
                              FollowedLegs& followed) {
  std::vector<LegResult>& results = followed.results;
  const std::vector<std::size_t> places = places_of(results, is_unsettled);
  std::vector<Route> routes;
  for (const std::size_t place : places) routes.push_back(standing(*legs[place].route));
  std::vector<Leg> unsettled;
  for (std::size_t i = 0; i < places.size(); ++i)
    unsettled.push_back({results[places[i]].x.data(), &routes[i]});
  std::vector<LegResult> settled = follow_with(wide_trackers_, unsettled, stopped, followed.work);
  for (std::size_t i = 0; i < places.size(); ++i) {
    settled[i].state.steps += results[places[i]].state.steps;
    settled[i].state.rejected += results[places[i]].state.rejected;
    results[places[i]] = std::move(settled[i]);
  }
}

std::vector<LegResult> LegTracking::follow_with(Trackers& trackers, std::span<const Leg> legs,
                                                const std::function<bool()>& stopped, LegWork& work) const {
  std::vector<LegResult> results(legs.size());
  std::atomic<std::size_t> next = 0;
  const std::size_t lanes = static_cast<std::size_t>(trackers.front()->lanes());
  const std::size_t full_trackers = (legs.size() + lanes - 1) / lanes;
  run_on_threads(static_cast<int>(std::min(trackers.size(), full_trackers)), [&](int i) {
    LegFeeder(*trackers[static_cast<std::size_t>(i)], unknowns_, legs, next, results).run(stopped);
  });
  add_work(results, work);
  return results;
}

}  // namespace gcs
