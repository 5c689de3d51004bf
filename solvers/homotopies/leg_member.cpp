#include "solvers/homotopies/leg_member.hpp"

#include <utility>
#include <variant>

namespace gcs {

LegMember::LegMember(std::string_view task) : task_(read_task(task)) {
  TrackingSetup setup{task_.options, is_available(task_.set) ? task_.set : widest_instruction_set(),
                      task_.threads};
  setup.all_wide = task_.all_wide;
  tracking_ = std::visit(
      [&](const auto& system) { return std::make_unique<LegTracking>(system, task_.elimination, setup); },
      task_.system);
}

std::string LegMember::result(std::string_view item) {
  const SentLegs sent = read_legs(item);
  const std::vector<Leg> legs = sent.legs();
  return to_message(tracking_->follow_here(legs, [] { return false; }));
}

}  // namespace gcs
