#include "solvers/homotopies/leg_stream.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace gcs {
namespace {

/// Between two looks at what has come: shorter than a few legs take, and far longer than a look.
constexpr int steps_between_messages = 32;
/// Where there is nothing to follow: as long.
constexpr std::chrono::milliseconds longest_wait(1);

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

LegStream::LegStream(int unknowns, LaneTrackers trackers, LaneTrackers wide_trackers)
    : unknowns_(unknowns), others_(static_cast<int>(trackers.size()) - 1) {
  for (std::size_t i = 0; i < trackers.size(); ++i)
    feeders_.push_back({Lanes(std::move(trackers[i])), Lanes(std::move(wide_trackers[i]))});
}

std::atomic<std::size_t>& LegStream::waiting(LegArithmetic arithmetic) {
  return arithmetic == LegArithmetic::wide ? waiting_wide_ : waiting_;
}

void LegStream::add(std::uint64_t number, std::vector<Leg> legs, LegArithmetic arithmetic) {
  const std::size_t count = legs.size();
  const std::scoped_lock lock(mutex_);
  lists_.push_back(std::make_unique<List>(
      List{number, arithmetic, std::move(legs), std::vector<LegResult>(count), 0, count}));
  waiting(arithmetic) += count;
  if (count == 0) ++done_;
  call_others();
}

/// No more than have legs for their lanes. Precondition: locked.
void LegStream::call_others() {
  std::size_t doubles = 0, wide = 0;  // legs that no feeder before has
  for (const std::unique_ptr<List>& list : lists_)
    (list->arithmetic == LegArithmetic::wide ? wide : doubles) += list->open;
  const auto take = [](std::size_t& legs, const Lanes& lanes) {
    legs -= std::min(legs, lanes.places.size());
  };
  for (std::size_t i = 0; i < feeders_.size() && doubles + wide > 0; ++i) {
    Feeder& feeder = feeders_[i];
    take(doubles, feeder.doubles);
    take(wide, feeder.wide);
    if (i > 0 && !std::exchange(feeder.is_at_work, true))
      others_.run(static_cast<int>(i) - 1, [this, &feeder] { work(feeder); });
  }
}

void LegStream::work(Feeder& feeder) {
  try {
    while (!gives_up_) {
      if (step(feeder)) continue;
      const std::scoped_lock lock(mutex_);
      if (waiting_ + waiting_wide_ > 0) continue;
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
  for (int i = 0; i < steps_between_messages && has_legs && done_ == 0; ++i)
    has_legs = step(feeders_.front());
  std::unique_lock lock(mutex_);
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
    if (list->open == 0) done.push_back({list->number, {std::move(list->results), {}}});
  for (FollowedList& list : done) list.legs.work = work_of(list.legs.results);
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
    const LegWork work = work_of(list->results);
    rest.push_back({list->number, {std::move(list->results), work}});
  }
  lists_.clear();
  for (Feeder& feeder : feeders_) {
    feeder.is_at_work = false;
    for (Lanes* lanes : {&feeder.doubles, &feeder.wide}) std::ranges::fill(lanes->places, Place{});
  }
  waiting_ = waiting_wide_ = done_ = 0;
  failure_ = nullptr;
  return rest;
}

/// Of its lanes with legs; false where none has one.
bool LegStream::step(Feeder& feeder) {
  const bool has_doubles = refill(feeder.doubles, LegArithmetic::doubles);
  const bool has_wide = refill(feeder.wide, LegArithmetic::wide);
  if (has_doubles) step(feeder.doubles);
  if (has_wide) step(feeder.wide);
  return has_doubles || has_wide;
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
  if (--place.list->open == 0) {
    ++done_;
    list_done_.notify_one();
  }
  place = {};
}

void LegItems::add(NumberedItem item) {
  const SentLegs& sent = sent_[item.number] = read_legs(item.bytes);
  stream_->add(item.number, sent.legs(), sent.arithmetic);
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
