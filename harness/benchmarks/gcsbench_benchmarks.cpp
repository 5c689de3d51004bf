/// Times every strategy with each of its modes or methods on every shipped instance that it supports, through
/// the same interface as the program. Answers are not assessed here: `gcsbench tables` does that. Kernels
/// register themselves with BENCHMARK in files of their own.
///   gcsbench_benchmarks --benchmark_filter='rcp.*/disulfide'
///   gcsbench_benchmarks --benchmark_filter='(cayley-menger|rcp|full-space).*/octahedron'
///   gcsbench_benchmarks --benchmark_filter='theta-scan|sphere-tangents|plan-scan'

#include <benchmark/benchmark.h>

#include <deque>
#include <exception>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace {

using namespace gcs;

struct NamedScene {
  std::string id;
  Scene scene;
};

/// The words between the bars.
std::vector<std::string> words_of(std::string_view allowed) {
  std::vector<std::string> words;
  for (auto bar = allowed.find('|'); bar != std::string_view::npos; bar = allowed.find('|')) {
    words.emplace_back(allowed.substr(0, bar));
    allowed.remove_prefix(bar + 1);
  }
  words.emplace_back(allowed);
  return words;
}

/// The options that choose each of the strategy's algorithms: all values of `mode` or `method`; none where it
/// has but one.
std::vector<OptionMap> algorithms_of(const StrategyEntry& entry) {
  std::vector<OptionMap> algorithms;
  for (const OptionSpec& option : entry.options) {
    if (option.name != "mode" && option.name != "method") continue;
    for (const std::string& word : words_of(option.allowed))
      algorithms.push_back({{std::string(option.name), word}});
  }
  if (algorithms.empty()) algorithms.emplace_back();
  return algorithms;
}

/// One iteration is what somebody who solves once waits for: a fresh strategy, prepare and solve.
void time_solving(benchmark::State& state, const StrategyEntry& entry, const OptionMap& options,
                  const Scene& scene) {
  const SolveRequest request(scene);
  for (auto _ : state) {
    const auto strategy = entry.make(options);
    strategy->prepare(request);
    const SolveReport report = strategy->solve(request);
    if (report.status != SolveStatus::complete) state.SkipWithError(report.reason.c_str());
    state.counters["iterations"] = static_cast<double>(report.work.iterations);
  }
}

void register_solving(const StrategyEntry& entry, const OptionMap& algorithm, const NamedScene& named) {
  const OptionMap options = complete_options(entry, algorithm);
  if (why_not(entry, *entry.make(options), named.scene)) return;
  std::string name(entry.name);
  for (const auto& choice : algorithm) name += "/" + choice.second;
  benchmark::RegisterBenchmark((name + "/" + named.id).c_str(), time_solving, entry, options, named.scene)
      ->Unit(benchmark::kMillisecond);
}

std::deque<NamedScene> shipped_scenes() {
  std::deque<NamedScene> scenes;
  for (const std::string& id : shipped_instances()) scenes.push_back({id, Scene(load_instance(id))});
  return scenes;
}

void register_everything() {
  for (const NamedScene& named : shipped_scenes()) {
    for (const StrategyEntry& entry : all_strategies()) {
      for (const OptionMap& algorithm : algorithms_of(entry)) register_solving(entry, algorithm, named);
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
