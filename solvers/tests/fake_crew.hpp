#pragma once
/// Other processes within one: all that passes are messages.

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "solvers/running/crew.hpp"

namespace gcs {

/// Does every other item by a member of its own.
class FakeCrew final : public Crew {
 public:
  using Begin = std::function<std::unique_ptr<ItemWork>(const std::string& task)>;
  explicit FakeCrew(Begin begin) : begin_(std::move(begin)) {}

  int members() const override { return 3; }
  int members_here() const override { return 3; }
  std::unique_ptr<ItemWork> share(const std::string& task, ItemWork& here) override {
    return std::make_unique<Shared>(*this, begin_(task), here);
  }

  std::size_t handed_out = 0;

 private:
  /// The member goes on first.
  class Shared final : public ItemWork {
   public:
    Shared(FakeCrew& crew, std::unique_ptr<ItemWork> member, ItemWork& here)
        : crew_(crew), member_(std::move(member)), here_(here) {}

    void add(NumberedItem item) override {
      const bool is_here = item.number % 2 == 0;
      if (!is_here) ++crew_.handed_out;
      (is_here ? here_ : *member_).add(std::move(item));
    }
    std::size_t reserve() const override { return here_.reserve(); }
    bool is_idle() const override { return member_->is_idle() && here_.is_idle(); }
    std::vector<NumberedItem> advance() override { return (member_->is_idle() ? here_ : *member_).advance(); }

   private:
    FakeCrew& crew_;
    std::unique_ptr<ItemWork> member_;
    ItemWork& here_;
  };

  Begin begin_;
};

}  // namespace gcs
