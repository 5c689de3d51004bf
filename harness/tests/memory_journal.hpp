#pragma once
/// A journal that keeps its records in memory and can stop the solve that writes it.

#include <stdexcept>
#include <stop_token>
#include <utility>
#include <vector>

#include "solvers/running/journal.hpp"

namespace gcs {

class MemoryJournal final : public Journal {
 public:
  using Records = std::vector<std::pair<std::uint64_t, Block>>;

  /// Goes on from `records`.
  explicit MemoryJournal(Records records = {}) : records_(std::move(records)) {}

  /// Asks `stop` as soon as there are so many records.
  void stop_at(std::size_t records, std::stop_source& stop) {
    most_ = records;
    stop_ = &stop;
  }

  std::optional<Block> result(std::uint64_t fingerprint,
                              const std::function<std::optional<Block>()>& compute) override {
    if (next_ < records_.size()) {
      const auto& [known, block] = records_[next_++];
      if (known != fingerprint) throw std::logic_error("another step is asked for than was recorded");
      return block;
    }
    std::optional<Block> block = compute();
    if (!block) return block;
    ++computed_;
    next_ = records_.size() + 1;
    records_.emplace_back(fingerprint, *block);
    if (stop_ && records_.size() >= most_) stop_->request_stop();
    return block;
  }

  const Records& records() const { return records_; }
  std::size_t computed() const { return computed_; }

 private:
  Records records_;
  std::size_t next_ = 0;
  std::size_t computed_ = 0;
  std::size_t most_ = 0;
  std::stop_source* stop_ = nullptr;
};

}  // namespace gcs
