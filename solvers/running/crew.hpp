#pragma once
/// Other processes that take over parts of a solve.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace gcs {

/// An item's or its result's bytes, with its number.
struct NumberedItem {
  std::uint64_t number = 0;
  std::string bytes;
};

/// What one process does of the items of one task. Throws where it cannot; then all that it has is lost.
class ItemWork {
 public:
  virtual ~ItemWork() = default;
  virtual void add(NumberedItem item) = 0;
  /// With how many items beside the first one it need not wait for more.
  virtual std::size_t reserve() const = 0;
  /// Nothing that was added is left to do.
  virtual bool is_idle() const = 0;
  /// Goes on for a while; the results that are there then.
  virtual std::vector<NumberedItem> advance() = 0;
};

/// One item after the other.
class OneByOne final : public ItemWork {
 public:
  using Function = std::function<std::string(const NumberedItem&)>;
  explicit OneByOne(Function result_of) : result_of_(std::move(result_of)) {}

  void add(NumberedItem item) override { items_.push_back(std::move(item)); }
  std::size_t reserve() const override { return 1; }
  bool is_idle() const override { return items_.empty(); }
  std::vector<NumberedItem> advance() override {
    const NumberedItem item = std::move(items_.front());
    items_.pop_front();
    return {{item.number, result_of_(item)}};
  }

 private:
  Function result_of_;
  std::deque<NumberedItem> items_;
};

class Crew {
 public:
  virtual ~Crew() = default;
  /// The processes that work, this one among them; at least 1.
  virtual int members() const = 0;
  /// Those on this machine, likewise. While this process works alone, the cores of the others are free.
  virtual int members_here() const = 0;
  /// Of the threads that work while the others wait, those of one process while none does.
  int threads_of_member(int threads) const { return std::max(1, threads / members_here()); }
  /// The work of all as that of one: items are handed out on demand, those with smaller numbers first, and `here` does what
  /// this process does of them.
  /// `task` is what they have in common; it, items and results are bytes that travel between machines of one kind.
  /// Throws std::runtime_error in advance() where another process fails. What is left at its end is given up; `here`
  /// may then have items left. Of one crew only one at a time; `here` outlives it.
  virtual std::unique_ptr<ItemWork> share(const std::string& task, ItemWork& here) = 0;

  /// Hands the results of items 0 to count − 1 to `take`, whoever did which and in any order, by share(). `item_of` makes an
  /// item shortly before somebody needs it, so that few of many are there at once. What is left where `stopped()` comes
  /// first has no result.
  void each_result(const std::string& task, std::size_t count,
                   const std::function<std::string(std::size_t)>& item_of, ItemWork& here,
                   const std::function<bool()>& stopped, const std::function<void(NumberedItem)>& take);
};

}  // namespace gcs
