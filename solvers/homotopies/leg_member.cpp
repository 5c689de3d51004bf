#include "solvers/homotopies/leg_member.hpp"

#include <memory>
#include <utility>
#include <variant>

#include "solvers/homotopies/leg_message.hpp"
#include "solvers/homotopies/leg_tracking.hpp"

namespace gcs {
namespace {

class LegMember final : public ItemWork {
 public:
  explicit LegMember(const std::string& task) : task_(read_task(task)) {
    TrackingSetup setup{task_.options, is_available(task_.set) ? task_.set : widest_instruction_set(),
                        task_.threads};
    setup.all_wide = task_.all_wide;
    stream_ = std::visit(
        [&](const auto& system) { return make_leg_stream(system, task_.elimination, setup); }, task_.system);
    items_ = std::make_unique<LegItems>(*stream_);
  }

  void add(NumberedItem item) override { items_->add(std::move(item)); }
  std::size_t reserve() const override { return items_->reserve(); }
  bool is_idle() const override { return items_->is_idle(); }
  std::vector<NumberedItem> advance() override { return items_->advance(); }

 private:
  LegTask task_;
  std::unique_ptr<LegStream> stream_;
  std::unique_ptr<LegItems> items_;
};

}  // namespace

std::unique_ptr<ItemWork> begin_legs(const std::string& task) { return std::make_unique<LegMember>(task); }

}  // namespace gcs
