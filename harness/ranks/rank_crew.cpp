#include "harness/ranks/rank_crew.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#include "harness/base/errors.hpp"

namespace gcs {
namespace {

enum Tag : int { build_tag, task_tag, item_tag, result_tag, failure_tag, leave_tag };

struct Message {
  int from = 0;
  int tag = 0;
  std::string bytes;
};

std::optional<Message> next_message(const MessagePassing& passing) {
  Message message;
  std::size_t count = 0;
  if (!passing.has_come(&message.from, &message.tag, &count)) return std::nullopt;
  message.bytes.resize(count);
  passing.receive(message.from, message.tag, message.bytes.data(), count);
  return message;
}

/// Whoever waits leaves the core to others: MPI's own waiting takes all of it. A large message takes several looks of both
/// sides, so that these are not to be further apart than a small part of the time that was waited.
Message wait_for_message(const MessagePassing& passing) {
  using Clock = std::chrono::steady_clock;
  constexpr Clock::duration shortest = std::chrono::microseconds(10),
                            longest = std::chrono::microseconds(500);
  const Clock::time_point start = Clock::now();
  while (true) {
    if (auto message = next_message(passing)) return *std::move(message);
    std::this_thread::sleep_for(std::clamp((Clock::now() - start) / 64, shortest, longest));
  }
}

void send(const MessagePassing& passing, int to, Tag tag, const std::string& bytes) {
  passing.send(to, tag, bytes.data(), bytes.size());
}

/// An item or a result with its number.
std::string numbered(std::uint64_t number, const std::string& bytes) {
  std::string message(sizeof number, '\0');
  std::memcpy(message.data(), &number, sizeof number);
  return message + bytes;
}

std::pair<std::uint64_t, std::string> number_and_bytes(const std::string& message) {
  std::uint64_t number = 0;
  if (message.size() < sizeof number) throw std::invalid_argument("a message without a number");
  std::memcpy(&number, message.data(), sizeof number);
  return {number, message.substr(sizeof number)};
}

}  // namespace

std::optional<int> next_receiver(const std::vector<int>& queued, std::size_t left) {
  const auto first_with = [&](int number) -> std::optional<int> {
    const auto found = std::find(queued.begin() + 1, queued.end(), number);
    return found != queued.end() ? std::optional(static_cast<int>(found - queued.begin())) : std::nullopt;
  };
  if (left == 0) return std::nullopt;
  if (const auto idle = first_with(0)) return idle;
  return left >= queued.size() ? first_with(1) : std::nullopt;
}

RankCrew::RankCrew(const MessagePassing& passing, const std::string& build)
    : passing_(passing), told_(static_cast<std::size_t>(passing.size)) {
  for (int waiting = passing.size - 1; waiting > 0; --waiting) {
    const Message message = wait_for_message(passing_);
    if (message.bytes != build)
      misfit_ = fmt::format("rank {} runs another program than rank 0: {}, and {}", message.from,
                            message.bytes, build);
  }
}

RankCrew::~RankCrew() {
  for (int rank = 1; rank < passing_.size; ++rank) send(passing_, rank, leave_tag, "");
}

/// What is under way of one list of items.
class RankCrew::Hand {
 public:
  Hand(RankCrew& crew, const std::string& task, const std::vector<std::string>& items)
      : crew_(crew),
        task_(task),
        items_(items),
        results_(items.size()),
        queued_(static_cast<std::size_t>(crew.members()), 0) {}

  bool is_all_given() const { return next_ == items_.size(); }
  bool has_failed() const { return !failure_.empty(); }

  void hand_out() {
    while (const auto rank = next_receiver(queued_, items_.size() - next_)) give(*rank);
  }

  void do_one(const std::function<std::string(std::size_t)>& here) {
    const std::size_t own = next_++;
    results_[own] = here(own);
  }

  void take_what_has_come() {
    while (const auto message = next_message(crew_.passing_)) take(*message);
  }

  /// Nothing is left behind that the next call would take for its own.
  void take_rest() {
    while (under_way_ > 0) take(wait_for_message(crew_.passing_));
  }

  std::vector<std::string> results() && {
    if (has_failed()) throw std::runtime_error(failure_);
    return std::move(results_);
  }

 private:
  void give(int rank) {
    std::string& told = crew_.told_[static_cast<std::size_t>(rank)];
    if (told != task_) send(crew_.passing_, rank, task_tag, told = task_);
    send(crew_.passing_, rank, item_tag, numbered(next_, items_[next_]));
    ++next_;
    ++queued_[static_cast<std::size_t>(rank)];
    ++under_way_;
  }

  void take(const Message& message) {
    auto [number, bytes] = number_and_bytes(message.bytes);
    if (message.tag == failure_tag)
      failure_ = fmt::format("rank {}: {}", message.from, bytes);
    else
      results_.at(number) = std::move(bytes);
    --queued_[static_cast<std::size_t>(message.from)];
    --under_way_;
  }

  RankCrew& crew_;
  const std::string& task_;
  const std::vector<std::string>& items_;
  std::vector<std::string> results_;
  std::vector<int> queued_;  // of each rank
  std::size_t next_ = 0;     // item that nobody has
  std::size_t under_way_ = 0;
  std::string failure_;
};

std::vector<std::string> RankCrew::results(const std::string& task, const std::vector<std::string>& items,
                                           const std::function<std::string(std::size_t)>& here,
                                           const std::function<bool()>& stopped) {
  Hand hand(*this, task, items);
  try {
    while (!hand.is_all_given() && !hand.has_failed() && !stopped()) {
      hand.take_what_has_come();
      hand.hand_out();
      if (!hand.is_all_given()) hand.do_one(here);
    }
  } catch (...) {
    hand.take_rest();
    throw;
  }
  hand.take_rest();
  return std::move(hand).results();
}

namespace {

/// Why `work` failed; empty where it did not.
template <class Work>
std::string failure_of(Work work) {
  try {
    work();
    return "";
  } catch (const std::bad_alloc&) {
    return "no memory is left";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace

void serve(const MessagePassing& passing, const std::string& build,
           const std::function<ItemWork(const std::string& task)>& begin) {
  send(passing, 0, build_tag, build);
  ItemWork work;
  std::string failure;  // of the task
  while (true) {
    const Message message = wait_for_message(passing);
    if (message.tag == leave_tag) return;
    if (message.tag == task_tag) {
      work = nullptr;  // two tasks may need more memory than there is
      failure = failure_of([&] { work = begin(message.bytes); });
      continue;
    }
    const auto [number, item] = number_and_bytes(message.bytes);
    std::string result, why = failure;
    if (why.empty()) why = failure_of([&, &bytes = item] { result = work(bytes); });
    send(passing, 0, why.empty() ? result_tag : failure_tag, numbered(number, why.empty() ? result : why));
  }
}

}  // namespace gcs
