#pragma once
/// Other processes within one: all that passes are messages.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "solvers/running/crew.hpp"

namespace gcs {

/// Does every other item by a member of its own, the last items first.
class FakeCrew final : public Crew {
 public:
  explicit FakeCrew(std::function<ItemWork(const std::string& task)> begin) : begin_(std::move(begin)) {}

  int members() const override { return 3; }
  std::vector<std::string> results(const std::string& task, const std::vector<std::string>& items,
                                   const std::function<std::string(std::size_t)>& here,
                                   const std::function<bool()>& stopped) override {
    const ItemWork member = begin_(task);
    std::vector<std::string> done(items.size());
    for (std::size_t i = items.size(); i-- > 0 && !stopped();)
      done[i] = i % 2 == 0 ? here(i) : member(items[i]);
    handed_out += items.size() / 2;
    return done;
  }

  std::size_t handed_out = 0;

 private:
  std::function<ItemWork(const std::string& task)> begin_;
};

}  // namespace gcs
