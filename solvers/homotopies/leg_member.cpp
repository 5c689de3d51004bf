#include "solvers/homotopies/leg_member.hpp"

#include <memory>
#include <variant>

#include "solvers/homotopies/leg_message.hpp"
#include "solvers/homotopies/leg_tracking.hpp"

namespace gcs {
namespace {

/// A stream, and what it refers to.
struct TaskStream {
  explicit TaskStream(const std::string& message) : task(read_task(message)) {
    TrackingSetup setup{task.options, is_available(task.set) ? task.set : widest_instruction_set(),
                        task.threads};
    setup.all_wide = task.all_wide;
    stream = std::visit([&](const auto& system) { return make_leg_stream(system, task.elimination, setup); },
                        task.system);
  }

  LegTask task;
  std::unique_ptr<LegStream> stream;
};

}  // namespace

std::unique_ptr<ItemWork> begin_legs(const std::string& task) {
  const auto whole = std::make_shared<TaskStream>(task);
  return std::make_unique<LegItems>(std::shared_ptr<LegStream>(whole, whole->stream.get()));
}

}  // namespace gcs
