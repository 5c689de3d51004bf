/// libFuzzer's target for everything that the program reads: whatever a file holds, it is either read or
/// refused with InputError.

#include <cstddef>
#include <cstdint>
#include <string>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/result_reader.hpp"
#include "harness/runs/published.hpp"
#include "harness/runs/run_file.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/reading/json_document.hpp"

namespace gcs {

namespace {

template <typename Reader>
void read_or_refuse(const Reader& reader) {
  try {
    reader();
  } catch (const InputError&) {
  }
}

/// What describe and solve ask before any work that grows with more than the file.
void look_at(const Instance& instance) {
  if (instance.problem.points.size() > 30) return;
  const Scene scene = instance;
  for (const StrategyEntry& entry : all_strategies())
    entry.make(complete_options(entry, {}))->why_unsupported(scene);
}

}  // namespace

}  // namespace gcs

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  gcs::read_or_refuse([&] { gcs::look_at(gcs::parse_instance(text, "fuzz")); });
  gcs::read_or_refuse([&] { gcs::parse_result(text, "fuzz"); });
  gcs::read_or_refuse([&] { gcs::parse_run_file(text, "fuzz"); });
  gcs::read_or_refuse([&] { gcs::parse_publication(text, "fuzz"); });
  return 0;
}
