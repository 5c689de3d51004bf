#include "solvers/homotopies/leg_stream.hpp"

#include <algorithm>
#include <utility>

#include "solvers/running/run_on_threads.hpp"

namespace gcs {
namespace {

/// Of every tracker between two looks at what has come: shorter than a few legs take, and far longer than a look.
constexpr std::int64_t steps_between_messages = 32;

LegWork work_of(const std::vector<LegResult>& results) {
  LegWork work;
  for (const LegResult& result : results) {
    work.accepted += result.state.steps - result.state.rejected;
    work.rejected += result.state.rejected;
    work.evaluations += result.state.steps + 2;  // with the start and the end
  }
  return work;
}

}  // namespace

LegStream::Lanes::Lanes(std::unique_ptr<LaneTracker> made)
    : tracker(std::move(made)), places(static_cast<std::size_t>(tracker->lanes())) {}

bool LegStream::Lanes::are_busy() const {
  return std::any_of(places.begin(), places.end(), [](const Place& place) { return place.list != nullptr; });
}

LegStream::LegStream(int unknowns, LaneTrackers trackers, LaneTrackers wide_trackers) : unknowns_(unknowns) {
  for (std::size_t i = 0; i < trackers.size(); ++i)
    feeders_.push_back({Lanes(std::move(trackers[i])), Lanes(std::move(wide_trackers[i]))});
}

std::atomic<std::size_t>& LegStream::waiting(LegArithmetic arithmetic) {
  return arithmetic == LegArithmetic::wide ? waiting_wide_ : waiting_;
}

void LegStream::add(std::uint64_t number, std::vector<Leg> legs, LegArithmetic arithmetic) {
  const std::size_t count = legs.size();
  lists_.push_back(std::make_unique<List>(
      List{number, arithmetic, std::move(legs), std::vector<LegResult>(count), 0, count}));
  waiting(arithmetic) += count;
}

std::vector<FollowedList> LegStream::advance(std::int64_t most_steps, const std::function<bool()>& stopped) {
  const std::vector<Feeder*> feeders = needed_feeders();
  run_on_threads(static_cast<int>(feeders.size()),
                 [&](int i) { feed(*feeders[static_cast<std::size_t>(i)], most_steps, stopped); });
  std::vector<FollowedList> done;
  for (const std::unique_ptr<List>& list : lists_)
    if (list->open == 0) done.push_back({list->number, {std::move(list->results), {}}});
  for (FollowedList& list : done) list.legs.work = work_of(list.legs.results);
  std::erase_if(lists_, [](const std::unique_ptr<List>& list) { return list->open == 0; });
  return done;
}

std::vector<FollowedList> LegStream::give_up() {
  std::vector<FollowedList> rest;
  for (const std::unique_ptr<List>& list : lists_) {
    const LegWork work = work_of(list->results);
    rest.push_back({list->number, {std::move(list->results), work}});
  }
  lists_.clear();
  for (Feeder& feeder : feeders_)
    for (Lanes* lanes : {&feeder.doubles, &feeder.wide}) std::ranges::fill(lanes->places, Place{});
  waiting_ = waiting_wide_ = 0;
  return rest;
}

/// Those with legs in their lanes, and no more than fill theirs with those that wait.
std::vector<LegStream::Feeder*> LegStream::needed_feeders() {
  std::vector<Feeder*> needed;
  std::size_t doubles = waiting_, wide = waiting_wide_;
  const auto take = [](std::size_t& legs, const Lanes& lanes) {
    legs -= std::min(legs, lanes.places.size());
  };
  for (Feeder& feeder : feeders_) {
    if (doubles + wide == 0 && !feeder.doubles.are_busy() && !feeder.wide.are_busy()) continue;
    needed.push_back(&feeder);
    take(doubles, feeder.doubles);
    take(wide, feeder.wide);
  }
  return needed;
}

void LegStream::feed(Feeder& feeder, std::int64_t most_steps, const std::function<bool()>& stopped) {
  for (std::int64_t steps = 0; steps < most_steps; ++steps) {
    const bool has_doubles = refill(feeder.doubles, LegArithmetic::doubles);
    const bool has_wide = refill(feeder.wide, LegArithmetic::wide);
    if ((!has_doubles && !has_wide) || stopped()) return;
    if (has_doubles) step(feeder.doubles);
    if (has_wide) step(feeder.wide);
  }
}

/// False where all lanes are empty.
bool LegStream::refill(Lanes& lanes, LegArithmetic arithmetic) {
  bool is_busy = false;
  for (std::size_t lane = 0; lane < lanes.places.size(); ++lane) {
    Place& place = lanes.places[lane];
    if (place.list == nullptr) {
      place = next_leg(arithmetic);
      if (place.list != nullptr) lanes.tracker->load(static_cast<int>(lane), place.list->legs[place.leg]);
    }
    is_busy = is_busy || place.list != nullptr;
  }
  return is_busy;
}

LegStream::Place LegStream::next_leg(LegArithmetic arithmetic) {
  if (waiting(arithmetic) == 0) return {};
  const std::scoped_lock lock(mutex_);
  for (const std::unique_ptr<List>& list : lists_) {
    if (list->arithmetic != arithmetic || list->next == list->legs.size()) continue;
    --waiting(arithmetic);
    return {list.get(), list->next++};
  }
  return {};
}

void LegStream::step(Lanes& lanes) {
  lanes.tracker->step();
  for (int lane = 0; lane < lanes.tracker->lanes(); ++lane)
    if (lanes.places[static_cast<std::size_t>(lane)].list != nullptr && !lanes.tracker->is_busy(lane))
      take_result(lanes, lane);
}

void LegStream::take_result(Lanes& lanes, int lane) {
  Place& place = lanes.places[static_cast<std::size_t>(lane)];
  LegResult& result = place.list->results[place.leg];
  result.state = lanes.tracker->state(lane);
  result.x.resize(static_cast<std::size_t>(unknowns_));
  lanes.tracker->read(lane, result.x.data());
  const std::scoped_lock lock(mutex_);
  --place.list->open;
  place = {};
}

void LegItems::add(NumberedItem item) {
  const SentLegs& sent = sent_[item.number] = read_legs(item.bytes);
  stream_.add(item.number, sent.legs(), sent.arithmetic);
}

std::vector<NumberedItem> LegItems::advance() {
  std::vector<NumberedItem> results;
  for (const FollowedList& list : stream_.advance(steps_between_messages, [] { return false; })) {
    sent_.erase(list.number);
    results.push_back({list.number, to_message(list.legs)});
  }
  return results;
}

}  // namespace gcs
