/// Times every strategy in each of its modes on every shipped instance that it supports, through the
/// same interface as the program. Answers are not assessed here: `gcsbench tables` does that. Kernels
/// register themselves with BENCHMARK in files of their own.
///   gcsbench_benchmarks --benchmark_filter='rcp.*/disulfide'

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <deque>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "harness/instance_io.hpp"
#include "harness/solve_run.hpp"
#include "solvers/strategy.hpp"

namespace {

using namespace gcs;

struct NamedScene {
  std::string id;
  Scene scene;
};

/// The values of the option `mode`, which are the words between the bars of what it allows; "" where there is
/// none.
std::vector<std::string> modes_of(const StrategyEntry& entry) {
  for (const OptionSpec& option : entry.options) {
    if (option.name != "mode") continue;
    std::vector<std::string> modes;
    std::string_view rest = option.allowed;
    for (auto bar = rest.find('|'); bar != std::string_view::npos; bar = rest.find('|')) {
      modes.emplace_back(rest.substr(0, bar));
      rest.remove_prefix(bar + 1);
    }
    modes.emplace_back(rest);
    return modes;
  }
  return {""};
}

/// One iteration is what somebody who solves once waits for: a fresh strategy, prepare and solve.
void time_solving(benchmark::State& state, const StrategyEntry& entry, const OptionMap& options,
                  const Scene& scene) {
  const SolveRequest request{scene, 1, 1, {}, nullptr};
  for (auto _ : state) {
    const auto strategy = entry.make(options);
    strategy->prepare(request);
    const SolveReport report = strategy->solve(request);
    if (report.status != SolveStatus::complete) state.SkipWithError(report.reason.c_str());
    state.counters["iterations"] = static_cast<double>(report.work.iterations);
  }
}

void register_solving(const StrategyEntry& entry, const std::string& mode, const NamedScene& named) {
  const OptionMap options = complete_options(entry, mode.empty() ? OptionMap{} : OptionMap{{"mode", mode}});
  if (why_not(entry, *entry.make(options), named.scene)) return;
  const std::string name = fmt::format("{}{}/{}", entry.name, mode.empty() ? "" : "/" + mode, named.id);
  benchmark::RegisterBenchmark(name.c_str(), time_solving, entry, options, named.scene)
      ->Unit(benchmark::kMillisecond);
}

std::deque<NamedScene> shipped_scenes() {
  std::deque<NamedScene> scenes;
  for (const std::string& id : shipped_instances()) scenes.push_back({id, Scene(load_instance(id).problem)});
  return scenes;
}

void register_everything() {
  for (const NamedScene& named : shipped_scenes()) {
    for (const StrategyEntry& entry : all_strategies()) {
      for (const std::string& mode : modes_of(entry)) register_solving(entry, mode, named);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  try {
    register_everything();
  } catch (const std::exception& error) {
    std::cerr << "gcsbench_benchmarks: " << error.what() << '\n';
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
