#include "solvers/homotopies/leg_stream.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace gcs {
namespace {

/// Between two looks at what has come: shorter than a few legs take, and far longer than a look. Of doubles; a wide step
/// takes as long as so many.
constexpr int steps_between_messages = 32, steps_of_wide_one = 16;
/// Where there is nothing to follow: as long.
constexpr std::chrono::milliseconds longest_wait(1);

LegWork work_of(const LegState& state) {
  // With the start and the end.
  return {state.steps - state.rejected, state.rejected, state.steps + 2};
}

bool is_lost(const LegResult& result) {
  return result.state.end == LegEnd::too_small || result.state.end == LegEnd::too_many;
}

bool is_unsettled(const LegResult& result) {
  return result.state.end == LegEnd::arrived && !result.state.is_settled();
}

}  // namespace

LegResult result_of(const LaneTracker& tracker, int lane, int unknowns) {
  LegResult result{tracker.state(lane), ComplexVectorX(static_cast<std::size_t>(unknowns))};
  tracker.read(lane, result.x.data());
  return result;
}

LegStream::List::List(std::uint64_t its_number, std::vector<Leg> its_legs)
    : number(its_number),
      legs(std::move(its_legs)),
      results(legs.size()),
      ways(legs.size(), Way::doubles),
      open(legs.size()) {}

LegStream::Lanes::Lanes(std::unique_ptr<LaneTracker> made)
    : tracker(std::move(made)), places(static_cast<std::size_t>(tracker->lanes())) {}

LegStream::LegStream(int unknowns, LaneTrackers trackers, LaneTrackers wide_trackers,
                     FollowReordered follow_reordered)
    : unknowns_(unknowns),
      follow_reordered_(std::move(follow_reordered)),
      others_(static_cast<int>(trackers.size()) - 1) {
  for (std::size_t i = 0; i < trackers.size(); ++i)
    feeders_.push_back({Lanes(std::move(trackers[i])), Lanes(std::move(wide_trackers[i]))});
}

void LegStream::add(std::uint64_t number, std::vector<Leg> legs) {
  const std::size_t count = legs.size();
  const std::scoped_lock lock(mutex_);
  lists_.push_back(std::make_unique<List>(number, std::move(legs)));
  for (std::size_t leg = 0; leg < count; ++leg) put(waiting_, {lists_.back().get(), leg});
  if (count == 0) ++done_;
  call_others();
}

/// No more than have legs for their lanes. Precondition: locked.
void LegStream::call_others() {
  std::size_t open = 0;  // that no feeder before has
  for (const std::unique_ptr<List>& list : lists_) open += list->open;
  for (std::size_t i = 0; i < feeders_.size() && open > 0; ++i) {
    Feeder& feeder = feeders_[i];
    open -= std::min(open, feeder.doubles.places.size());
    if (i > 0 && !std::exchange(feeder.is_at_work, true))
      others_.run(static_cast<int>(i) - 1, [this, &feeder] { work(feeder); });
  }
}

void LegStream::work(Feeder& feeder) {
  try {
    while (!gives_up_) {
      if (step(feeder) > 0) continue;
      const std::scoped_lock lock(mutex_);
      if (waiting_.count + waiting_wide_.count > 0) continue;
      feeder.is_at_work = false;
      return;
    }
  } catch (...) {
    const std::scoped_lock lock(mutex_);
    failure_ = std::current_exception();
    list_done_.notify_one();
  }
}

std::vector<FollowedList> LegStream::advance() {
  bool has_legs = true;
  for (int taken = 0; taken < steps_between_messages && has_legs && done_ == 0;) {
    const int steps = step(feeders_.front());
    has_legs = steps > 0;
    taken += steps;
  }
  std::unique_lock lock(mutex_);
  if (waiting_wide_.count > 0) call_others();  // who may be at rest
  if (!has_legs && !lists_.empty())
    list_done_.wait_for(lock, longest_wait, [&] { return done_ > 0 || failure_ != nullptr; });
  if (failure_ != nullptr) std::rethrow_exception(failure_);
  return done_lists();
}

/// Precondition: locked.
std::vector<FollowedList> LegStream::done_lists() {
  std::vector<FollowedList> done;
  if (done_ == 0) return done;
  for (const std::unique_ptr<List>& list : lists_)
    if (list->open == 0) done.push_back({list->number, {std::move(list->results), list->work}});
  std::erase_if(lists_, [](const std::unique_ptr<List>& list) { return list->open == 0; });
  done_ = 0;
  return done;
}

std::vector<FollowedList> LegStream::give_up() {
  gives_up_ = true;
  others_.wait();
  gives_up_ = false;
  std::vector<FollowedList> rest;
  for (const std::unique_ptr<List>& list : lists_) {
    for (std::size_t leg = 0; leg < list->legs.size(); ++leg)
      if (list->ways[leg] != Way::done) list->results[leg] = {};
    rest.push_back({list->number, {std::move(list->results), list->work}});
  }
  lists_.clear();
  for (Feeder& feeder : feeders_) {
    feeder.is_at_work = false;
    for (Lanes* lanes : {&feeder.doubles, &feeder.wide}) std::ranges::fill(lanes->places, Place{});
  }
  for (Waiting* waiting : {&waiting_, &waiting_wide_}) {
    waiting->places.clear();
    waiting->count = 0;
  }
  done_ = 0;
  failure_ = nullptr;
  return rest;
}

/// Of its lanes with legs. How long it took, in steps of doubles; 0 where none has one.
int LegStream::step(Feeder& feeder) {
  const bool has_doubles = refill(feeder.doubles, waiting_);
  // A wide step takes as long for a single leg as for all lanes.
  const bool are_enough = feeder.wide.is_busy() || 2 * waiting_wide_.count >= feeder.wide.places.size();
  const bool has_wide = (are_enough || !has_doubles) && refill(feeder.wide, waiting_wide_);
  if (has_doubles) step(feeder.doubles);
  if (has_wide) step(feeder.wide);
  return (has_doubles ? 1 : 0) + (has_wide ? steps_of_wide_one : 0);
}

bool LegStream::Lanes::is_busy() const {
  return std::ranges::any_of(places, [](const Place& place) { return place.list != nullptr; });
}

/// False where all lanes are empty.
bool LegStream::refill(Lanes& lanes, Waiting& waiting) {
  for (std::size_t lane = 0; lane < lanes.places.size(); ++lane) {
    Place& place = lanes.places[lane];
    if (place.list != nullptr) continue;
    place = next_leg(waiting);
    if (place.list != nullptr) lanes.tracker->load(static_cast<int>(lane), leg_of(place));
  }
  return lanes.is_busy();
}

LegStream::Place LegStream::next_leg(Waiting& waiting) {
  if (waiting.count == 0) return {};
  const std::scoped_lock lock(mutex_);
  if (waiting.places.empty()) return {};
  const Place place = waiting.places.front();
  waiting.places.pop_front();
  --waiting.count;
  return place;
}

/// Precondition: locked.
void LegStream::put(Waiting& waiting, Place place) {
  waiting.places.push_back(place);
  ++waiting.count;
}

/// As it is to be followed next.
Leg LegStream::leg_of(Place place) {
  Leg leg = place.list->legs[place.leg];
  if (place.list->ways[place.leg] != Way::wide_from_there) return leg;
  const LegResult& result = place.list->results[place.leg];
  leg.start = result.x.data();
  leg.from = result.state.s;
  return leg;
}

/// After `way` has ended with `result`.
LegStream::Way LegStream::next_way(Way way, const LegResult& result) {
  if (way == Way::doubles && (is_lost(result) || is_unsettled(result))) return Way::wide_from_there;
  if (way == Way::wide_from_there && is_lost(result)) return Way::wide_from_start;
  if (way == Way::wide_from_start && result.state.end == LegEnd::too_small) return Way::reordered;
  return Way::done;
}

void LegStream::step(Lanes& lanes) {
  lanes.tracker->step();
  for (int lane = 0; lane < lanes.tracker->lanes(); ++lane)
    if (lanes.places[static_cast<std::size_t>(lane)].list != nullptr && !lanes.tracker->is_busy(lane))
      take_result(lanes, lane);
}

void LegStream::take_result(Lanes& lanes, int lane) {
  const Place place = std::exchange(lanes.places[static_cast<std::size_t>(lane)], {});
  List& list = *place.list;
  LegWork work = keep(place, result_of(*lanes.tracker, lane, unknowns_));
  if (list.ways[place.leg] == Way::reordered) {
    auto result = follow_reordered_(list.legs[place.leg], list.results[place.leg], gives_up_);
    if (!result) return;
    work += keep(place, *std::move(result));
  }
  const std::scoped_lock lock(mutex_);
  list.work += work;
  if (list.ways[place.leg] != Way::done) return put(waiting_wide_, place);
  if (--list.open == 0) {
    ++done_;
    list_done_.notify_one();
  }
}

/// With what its earlier ways took. What this one did.
LegWork LegStream::keep(Place place, LegResult result) {
  LegResult& kept = place.list->results[place.leg];
  const LegWork work = work_of(result.state);
  result.state.steps += kept.state.steps;
  result.state.rejected += kept.state.rejected;
  kept = std::move(result);
  Way& way = place.list->ways[place.leg];
  way = next_way(way, kept);
  return work;
}

void LegItems::add(NumberedItem item) {
  const SentLegs& sent = sent_[item.number] = read_legs(item.bytes);
  stream_->add(item.number, sent.legs());
}

std::vector<NumberedItem> LegItems::advance() {
  std::vector<NumberedItem> results;
  for (const FollowedList& list : stream_->advance()) {
    sent_.erase(list.number);
    results.push_back({list.number, to_message(list.legs)});
  }
  return results;
}

}  // namespace gcs
