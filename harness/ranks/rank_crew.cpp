#include "harness/ranks/rank_crew.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <map>
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

std::string to_message(const NumberedItem& item) {
  std::string message(sizeof item.number, '\0');
  std::memcpy(message.data(), &item.number, sizeof item.number);
  return message + item.bytes;
}

NumberedItem to_item(const std::string& message) {
  NumberedItem item;
  if (message.size() < sizeof item.number) throw std::invalid_argument("a message without a number");
  std::memcpy(&item.number, message.data(), sizeof item.number);
  item.bytes = message.substr(sizeof item.number);
  return item;
}

}  // namespace

std::optional<int> next_receiver(const std::vector<int>& queued, std::size_t left, std::size_t reserve) {
  if (left == 0) return std::nullopt;
  const auto least = std::min_element(queued.begin() + 1, queued.end());
  const bool is_first = least == queued.end() || queued.front() < *least;
  const auto rank = static_cast<std::size_t>(is_first ? 0 : least - queued.begin());
  const bool has_room = static_cast<std::size_t>(queued[rank]) <= std::min(reserve, left / queued.size());
  return has_room ? std::optional(static_cast<int>(rank)) : std::nullopt;
}

RankCrew::RankCrew(const MessagePassing& passing, const std::string& build)
    : passing_(passing), told_(static_cast<std::size_t>(passing.size)) {
  passing_.spread(true);
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

class RankCrew::SharedWork final : public ItemWork {
 public:
  SharedWork(RankCrew& crew, const std::string& task, ItemWork& here)
      : crew_(crew), task_(task), here_(here), queued_(static_cast<std::size_t>(crew.members()), 0) {
    crew_.passing_.spread(false);
  }
  /// Nothing is left behind that the next one would take for its own.
  ~SharedWork() override {
    while (under_way_ > 0) take(wait_for_message(crew_.passing_));
    crew_.passing_.spread(true);
  }
  SharedWork(const SharedWork&) = delete;
  SharedWork& operator=(const SharedWork&) = delete;

  void add(NumberedItem item) override { waiting_.emplace(item.number, std::move(item.bytes)); }
  std::size_t reserve() const override { return here_.reserve(); }
  bool is_idle() const override { return waiting_.empty() && under_way_ == 0 && queued_.front() == 0; }

  std::vector<NumberedItem> advance() override {
    while (const auto message = next_message(crew_.passing_)) take(*message);
    const bool is_alone = waiting_.size() == 1 && under_way_ == 0 && here_.is_idle();
    if (is_alone) give(0);  // nobody is to wait for messages
    while (const auto rank = next_receiver(queued_, waiting_.size(), reserve())) give(*rank);
    go_on();
    if (!failure_.empty()) throw std::runtime_error(failure_);
    return std::exchange(results_, {});
  }

 private:
  void give(int rank) {
    auto item = waiting_.extract(waiting_.begin());
    if (rank == 0)
      here_.add({item.key(), std::move(item.mapped())});
    else
      send_item(rank, {item.key(), std::move(item.mapped())});
    ++queued_[static_cast<std::size_t>(rank)];
  }

  void send_item(int rank, const NumberedItem& item) {
    std::string& told = crew_.told_[static_cast<std::size_t>(rank)];
    if (told != task_) send(crew_.passing_, rank, task_tag, told = task_);
    send(crew_.passing_, rank, item_tag, to_message(item));
    ++under_way_;
  }

  /// With what this rank has; else it waits for what others have.
  void go_on() {
    if (!here_.is_idle())
      for (NumberedItem& result : here_.advance()) take(0, std::move(result));
    else if (under_way_ > 0)
      take(wait_for_message(crew_.passing_));
  }

  void take(const Message& message) {
    NumberedItem item = to_item(message.bytes);
    --under_way_;
    if (message.tag == failure_tag)
      failure_ = fmt::format("rank {}: {}", message.from, item.bytes);
    else
      take(message.from, std::move(item));
  }

  void take(int rank, NumberedItem result) {
    results_.push_back(std::move(result));
    --queued_[static_cast<std::size_t>(rank)];
  }

  RankCrew& crew_;
  const std::string task_;
  ItemWork& here_;
  std::map<std::uint64_t, std::string> waiting_;  // items that nobody has
  std::vector<NumberedItem> results_;
  std::vector<int> queued_;    // of each rank
  std::size_t under_way_ = 0;  // with others
  std::string failure_;
};

std::unique_ptr<ItemWork> RankCrew::share(const std::string& task, ItemWork& here) {
  return std::make_unique<SharedWork>(*this, task, here);
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

/// Of a rank after the first: its task, and which items it has.
class Server {
 public:
  using Begin = std::function<std::unique_ptr<ItemWork>(const std::string& task)>;
  Server(const MessagePassing& passing, const Begin& begin) : passing_(passing), begin_(begin) {}

  bool is_idle() const { return open_.empty(); }

  void take(const Message& message) {
    if (message.tag == task_tag) return begin(message.bytes);
    NumberedItem item = to_item(message.bytes);
    open_.push_back(item.number);
    unless_failed([&] { work_->add(std::move(item)); });
  }

  void advance() {
    std::vector<NumberedItem> results;
    unless_failed([&] { results = work_->advance(); });
    for (const NumberedItem& result : results) {
      send(passing_, 0, result_tag, to_message(result));
      std::erase(open_, result.number);
    }
  }

 private:
  void begin(const std::string& task) {
    work_.reset();  // two tasks may need more memory than there is
    failure_ = failure_of([&] { work_ = begin_(task); });
  }

  /// What has failed once says so of all its items.
  template <class Step>
  void unless_failed(Step step) {
    if (failure_.empty()) failure_ = failure_of(step);
    if (failure_.empty()) return;
    for (const std::uint64_t number : open_) send(passing_, 0, failure_tag, to_message({number, failure_}));
    open_.clear();
  }

  const MessagePassing& passing_;
  const Begin& begin_;
  std::unique_ptr<ItemWork> work_;
  std::string failure_;  // of the task
  std::vector<std::uint64_t> open_;
};

}  // namespace

void serve(const MessagePassing& passing, const std::string& build, const Server::Begin& begin) {
  send(passing, 0, build_tag, build);
  Server server(passing, begin);
  while (true) {
    std::optional<Message> message = next_message(passing);
    if (!message && server.is_idle()) message = wait_for_message(passing);
    if (!message) {
      server.advance();
      continue;
    }
    if (message->tag == leave_tag) return;
    server.take(*message);
  }
}

}  // namespace gcs
