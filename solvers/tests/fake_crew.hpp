#pragma once
/// Other processes within one: all that passes are messages.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "solvers/running/crew.hpp"

namespace gcs {

/// Does every other item by a member of its own, the last items first.
class FakeCrew final : public Crew {
 public:
  using Begin = std::function<std::unique_ptr<ItemWork>(const std::string& task)>;
  explicit FakeCrew(Begin begin) : begin_(std::move(begin)) {}

  int members() const override { return 3; }
  std::vector<std::string> results(const std::string& task, const std::vector<std::string>& items,
                                   ItemWork& here, const std::function<bool()>& stopped) override {
    const std::unique_ptr<ItemWork> member = begin_(task);
    std::vector<std::string> done(items.size());
    for (std::size_t i = items.size(); i-- > 0 && !stopped();)
      (i % 2 == 0 ? here : *member).add({i, items[i]});
    for (ItemWork* work : {&here, member.get()})
      while (!work->is_idle())
        for (NumberedItem& result : work->advance()) done.at(result.number) = std::move(result.bytes);
    handed_out += items.size() / 2;
    return done;
  }

  std::size_t handed_out = 0;

 private:
  Begin begin_;
};

}  // namespace gcs
