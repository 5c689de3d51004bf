#include "solvers/homotopies/leg_tracking.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace gcs {
namespace {

/// What is lost at most when a run is killed, and far more than all threads have in hand at once.
constexpr std::size_t legs_per_block = 4096;

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

FollowedLegs LegTracking::recall_or_follow(std::span<const Leg> legs, const Stopped& stopped) {
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

FollowedLegs LegTracking::follow_now(std::span<const Leg> legs, const Stopped& stopped) {
  FollowedLegs followed = follow_in(LegArithmetic::doubles, legs, stopped);
  follow_lost_again(legs, stopped, followed);
  settle_ends(legs, stopped, followed);
  return followed;
}

void LegTracking::follow_lost_again(std::span<const Leg> legs, const Stopped& stopped,
                                    FollowedLegs& followed) {
  const std::vector<std::size_t> places = places_of(followed.results, is_lost);
  std::vector<Leg> lost;
  for (const std::size_t place : places) lost.push_back(legs[place]);
  FollowedLegs again = follow_in(LegArithmetic::wide, lost, stopped);
  followed.work += again.work;
  for (std::size_t i = 0; i < places.size(); ++i) followed.results[places[i]] = std::move(again.results[i]);
}

void LegTracking::settle_ends(std::span<const Leg> legs, const Stopped& stopped, FollowedLegs& followed) {
  std::vector<LegResult>& results = followed.results;
  const std::vector<std::size_t> places = places_of(results, is_unsettled);
  std::vector<Route> routes;
  for (const std::size_t place : places) routes.push_back(standing(*legs[place].route));
  std::vector<Leg> unsettled;
  for (std::size_t i = 0; i < places.size(); ++i)
    unsettled.push_back({results[places[i]].x.data(), &routes[i]});
  FollowedLegs settled = follow_in(LegArithmetic::wide, unsettled, stopped);
  followed.work += settled.work;
  for (std::size_t i = 0; i < places.size(); ++i) {
    LegState& state = settled.results[i].state;
    state.steps += results[places[i]].state.steps;
    state.rejected += results[places[i]].state.rejected;
    results[places[i]] = std::move(settled.results[i]);
  }
}

FollowedLegs LegTracking::follow_in(LegArithmetic arithmetic, std::span<const Leg> legs,
                                    const Stopped& stopped) {
  return crew_ != nullptr && legs.size() > legs_of_item(arithmetic)
             ? follow_with_crew(arithmetic, legs, stopped)
             : follow_here(arithmetic, legs, stopped);
}

FollowedLegs LegTracking::follow_here(LegArithmetic arithmetic, std::span<const Leg> legs,
                                      const Stopped& stopped) {
  if (legs.empty()) return {};
  stream_->add(0, {legs.begin(), legs.end()}, arithmetic);
  std::vector<FollowedList> done = stream_->advance(std::numeric_limits<std::int64_t>::max(), stopped);
  if (done.empty()) done = stream_->give_up();
  return std::move(done.front().legs);
}

FollowedLegs LegTracking::follow_with_crew(LegArithmetic arithmetic, std::span<const Leg> legs,
                                           const Stopped& stopped) {
  const std::size_t most = legs_of_item(arithmetic);
  const auto legs_of = [&](std::size_t item) {
    return legs.subspan(item * most, std::min(most, legs.size() - item * most));
  };
  std::vector<std::string> items;
  for (std::size_t i = 0; i * most < legs.size(); ++i)
    items.push_back(to_message(legs_of(i), unknowns_, arithmetic));
  LegItems here(*stream_);
  const std::vector<std::string> results = crew_->results(task_, items, here, stopped);
  FollowedLegs followed;
  for (std::size_t i = 0; i < items.size(); ++i) {
    FollowedLegs some;
    if (!results[i].empty()) some = read_followed(results[i]);
    some.results.resize(legs_of(i).size());
    followed.work += some.work;
    std::move(some.results.begin(), some.results.end(), std::back_inserter(followed.results));
  }
  return followed;
}

/// Twice what fills the lanes of a member of this many threads. Wide ones take ten times as long.
std::size_t LegTracking::legs_of_item(LegArithmetic arithmetic) const {
  return (arithmetic == LegArithmetic::wide ? 8 : 16) * static_cast<std::size_t>(threads_);
}

}  // namespace gcs
