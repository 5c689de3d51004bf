#include "solvers/homotopies/leg_tracking.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>

namespace gcs {
namespace {

/// What is lost at most when a run is killed, and far more than all threads have in hand at once.
constexpr std::size_t legs_per_block = 4096;

}  // namespace

TrackingOptions wide(TrackingOptions options) {
  // Of twice the digits a prediction a hundred times as good needs few. A higher order would cost more than
  // the few steps that it saves.
  options.tolerance *= 1e-2;
  options.most_rejected = 200;  // nothing follows again what is lost here
  return options;
}

TrackingSetup of_member(TrackingSetup setup) {
  if (setup.crew != nullptr) setup.threads = setup.crew->threads_of_member(setup.threads);
  return setup;
}

void LegTracking::add(std::span<const Leg> legs) {
  blocks_.push_back(std::make_unique<Block>());
  Block& block = *blocks_.back();
  block.last_piece = ++last_block_ << 32U;
  block.sent = SentLegs(legs, unknowns_);
  block.legs = block.sent.legs();
  block.followed.results.resize(legs.size());
  block.open = legs.size();
}

std::vector<LegResult> LegTracking::take(const Stopped& stopped, WorkCounters& work) {
  Block& block = *blocks_.front();
  // Once stopped, what is asked for next is no longer what an undisturbed run asks for.
  if (setup_.journal != nullptr && !stopped())
    recall_or_follow(block, stopped);
  else
    follow(block, stopped);
  const std::unique_ptr<Block> taken = std::move(blocks_.front());
  blocks_.pop_front();
  if (pieces_.empty()) rest();
  taken->followed.work.add_to(work);
  return std::move(taken->followed.results);
}

void LegTracking::give_up() {
  leave();
  blocks_.clear();
}

std::vector<LegResult> LegTracking::follow(std::span<const Leg> legs, const Stopped& stopped,
                                           WorkCounters& work) {
  constexpr std::size_t blocks_at_once = 2;
  std::vector<LegResult> results;
  std::size_t added = 0;
  while (added < legs.size() || !blocks_.empty()) {
    while (added < legs.size() && blocks_.size() < blocks_at_once) {
      add(legs.subspan(added, std::min(legs_per_block, legs.size() - added)));
      added += blocks_.back()->legs.size();
    }
    std::ranges::move(take(stopped, work), std::back_inserter(results));
  }
  return results;
}

void LegTracking::recall_or_follow(Block& block, const Stopped& stopped) {
  const auto follow_all = [&]() -> std::optional<Journal::Block> {
    follow(block, stopped);
    if (stopped()) return std::nullopt;
    return to_block(block.followed);
  };
  const auto known = setup_.journal->result(fingerprint(block.legs, unknowns_), follow_all);
  if (known) block.followed = from_block(*known);
  if (block.followed.results.size() != block.legs.size())
    throw std::invalid_argument("a journal's block has not as many paths as were to be followed");
}

/// The first one, and others in lanes that it leaves empty.
void LegTracking::follow(Block& block, const Stopped& stopped) {
  for (const std::unique_ptr<Block>& one : blocks_)
    if (!one->is_handed_in && !stopped()) hand_in(*one);
  while (block.open > 0 && !stopped())
    for (FollowedList& list : advance()) sort_in(std::move(list));
  if (block.open > 0) leave();
}

void LegTracking::hand_in(Block& block) {
  if (setup_.crew != nullptr && shared_ == nullptr) {
    items_ = std::make_unique<LegItems>(stream_);
    shared_ = setup_.crew->share(task_, *items_);
  }
  block.is_handed_in = true;
  const std::span<const Leg> legs = block.legs;
  const std::size_t most = legs_of_piece();
  for (std::size_t first = 0; first < legs.size(); first += most) {
    const std::span<const Leg> some = legs.subspan(first, std::min(most, legs.size() - first));
    const std::uint64_t number = ++block.last_piece;
    pieces_[number] = {&block, first};
    if (shared_ != nullptr)
      shared_->add({number, to_message(some, unknowns_)});
    else
      stream_->add(number, {some.begin(), some.end()});
  }
}

std::vector<FollowedList> LegTracking::advance() {
  if (shared_ == nullptr) return stream_->advance();
  std::vector<FollowedList> lists;
  for (const NumberedItem& result : shared_->advance())
    lists.push_back({result.number, read_followed(result.bytes)});
  return lists;
}

/// Into its block.
void LegTracking::sort_in(FollowedList list) {
  const Piece piece = pieces_.extract(list.number).mapped();
  Block& block = *piece.block;
  block.followed.work += list.legs.work;
  block.open -= list.legs.results.size();
  std::ranges::move(list.legs.results,
                    block.followed.results.begin() + static_cast<std::ptrdiff_t>(piece.first));
}

/// All blocks as they are.
void LegTracking::leave() {
  rest();
  for (FollowedList& list : stream_->give_up()) sort_in(std::move(list));
  pieces_.clear();
  for (const std::unique_ptr<Block>& block : blocks_) {
    block->is_handed_in = true;
    block->open = 0;
  }
}

void LegTracking::rest() {
  shared_.reset();
  items_.reset();
}

/// Twice what fills the lanes of a member of this many threads.
std::size_t LegTracking::legs_of_piece() const {
  return setup_.crew == nullptr ? std::numeric_limits<std::size_t>::max()
                                : 16 * static_cast<std::size_t>(setup_.threads);
}

}  // namespace gcs
