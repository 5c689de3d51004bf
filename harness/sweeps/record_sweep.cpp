/// The program behind scripts/sweep-records: lengths at which many realisations of a graph are real.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/instances/problem_text.hpp"
#include "harness/sweeps/real_climb.hpp"
#include "harness/sweeps/sweep_main.hpp"

namespace {

using namespace gcs;
using Clock = std::chrono::steady_clock;

struct SweepOptions {
  std::vector<std::string> instances;
  double seconds = 60;
  std::uint64_t seed = 1;
  std::string out, report;
};

void add_options(CLI::App& app, SweepOptions& options) {
  app.add_option("instances", options.instances, "Where to begin: ids or files")->required();
  app.add_option("--seconds", options.seconds, "For each of them")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Of the random steps")->capture_default_str();
  app.add_option("--out", options.out, "Folder for the instances with the lengths that were reached")
      ->required();
  app.add_option("--report", options.report, "Markdown file for the table")->required();
}

/// laman-most@7 becomes laman-most-7.
std::string name_of(std::string id) {
  std::ranges::replace(id, '@', '-');
  return id;
}

std::string climb_from(const std::string& id, const SweepOptions& options) {
  const Instance instance = load_instance(id);
  const std::string name = name_of(instance.id);
  AtomicFile file(std::filesystem::path(options.out) / (name + ".json"));
  const auto end = Clock::now() + std::chrono::duration<double>(options.seconds);
  const auto say = [&](const CountedLengths& counted) {
    std::cerr << fmt::format("{}: {} of {} real\n", name, counted.real, counted.all);
  };
  const Climb climb = climb_to_real(instance.problem,
                                    {options.seed, [&] { return interrupted() || Clock::now() > end; }, say});
  if (climb.top.real > climb.real_at_start) file.commit(problem_text(Scene(climb.top.problem), name));
  return fmt::format("| {} | {} | {} | {} | {} |\n", instance.id, climb.top.all, climb.real_at_start,
                     climb.top.real, climb.scenes);
}

int sweep(const SweepOptions& options) {
  AtomicFile report(options.report);
  std::string rows;
  for (const std::string& id : options.instances)
    if (!interrupted()) rows += climb_from(id, options);
  report.commit(fmt::format(
      "# Lengths at which many realisations are real\n\n"
      "From the lengths of each instance, random ones of the families, to others at which more of all "
      "solutions, counted "
      "up to reflection, are real: fold by fold (`harness/sweeps/real_climb.hpp`), for {:g} s each or until "
      "all are, seed {}. "
      "*scenes*: lengths that were solved for all complex solutions. The lengths are the family `record`; "
      "`gcsbench tables "
      "records` certifies what is real there. Written by `scripts/sweep-records`.\n\n{}.\n\n"
      "| from | all | real there | real at the end | scenes |\n| --- | --: | --: | --: | --: |\n{}",
      options.seconds, options.seed, where_measured(), rows));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return gcs::sweep_main(argc, argv, "record_sweep", "Climbs to lengths at which many realisations are real.",
                         add_options, sweep);
}
