#include "solvers/homotopies/leg_member.hpp"

#include <memory>
#include <utility>
#include <variant>

#include "solvers/homotopies/leg_message.hpp"
#include "solvers/homotopies/leg_tracking.hpp"

namespace gcs {
namespace {

class LegMember {
 public:
  explicit LegMember(const std::string& task) : task_(read_task(task)) {
    TrackingSetup setup{task_.options, is_available(task_.set) ? task_.set : widest_instruction_set(),
                        task_.threads};
    setup.all_wide = task_.all_wide;
    tracking_ = std::visit(
        [&](const auto& system) { return std::make_unique<LegTracking>(system, task_.elimination, setup); },
        task_.system);
  }

  std::string result(const std::string& item) {
    const SentLegs sent = read_legs(item);
    const std::vector<Leg> legs = sent.legs();
    return to_message(tracking_->follow_here(legs, [] { return false; }));
  }

 private:
  LegTask task_;
  std::unique_ptr<LegTracking> tracking_;
};

}  // namespace

ItemWork begin_legs(const std::string& task) {
  const auto member = std::make_shared<LegMember>(task);
  return [member](const std::string& item) { return member->result(item); };
}

}  // namespace gcs
