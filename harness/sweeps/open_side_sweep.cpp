/// The program behind scripts/sweep-open-side: theta-scan against a much finer scan of the paper's kind for
/// many lengths of the open side. Exit code 1 when they differ.

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <map>
#include <random>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/sweeps/open_side_check.hpp"
#include "harness/sweeps/sweep_main.hpp"

namespace {

using namespace gcs;

constexpr const char* instance = "hoffmann-yuan";

struct SweepOptions {
  int values = 200;
  std::uint64_t seed = 1;
  int angles = 360'000;
  double band = 0.01;
  std::string out;
};

void add_options(CLI::App& app, SweepOptions& options) {
  app.add_option("--values", options.values, "How many random lengths")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the lengths")->capture_default_str();
  app.add_option("--angles", options.angles, "Angles of the fine scan in a full turn")
      ->check(CLI::Range(1, 10'000'000))
      ->capture_default_str();
  app.add_option("--band", options.band, "How near a sample must come to the length, in the file's unit")
      ->capture_default_str();
  app.add_option("--out", options.out, "Markdown file for the results")->required();
}

std::string row(const OpenSideVerdict& verdict) {
  return fmt::format("| {:.17g} | {} | {} | {} | {:.1e} |\n", verdict.length, verdict.solutions,
                     verdict.finer, verdict.together, verdict.closest);
}

std::string counts_table(const std::vector<OpenSideVerdict>& verdicts) {
  std::map<std::size_t, std::array<int, 2>> lengths;
  for (const OpenSideVerdict& verdict : verdicts) {
    ++lengths[verdict.solutions][0];
    lengths[verdict.solutions][1] += verdict.agrees() ? 1 : 0;
  }
  std::string table = "| solutions | lengths | of which agree |\n| --: | --: | --: |\n";
  for (const auto& [solutions, count] : lengths)
    table += fmt::format("| {} | {} | {} |\n", solutions, count[0], count[1]);
  return table;
}

std::string differences(const std::vector<OpenSideVerdict>& verdicts) {
  std::string rows;
  for (const OpenSideVerdict& verdict : verdicts)
    if (!verdict.agrees()) rows += row(verdict);
  if (rows.empty()) return "None.\n";
  return "| d34 | theta-scan | fine scan | together | closest two |\n| --: | --: | --: | --: | --: |\n" +
         rows;
}

std::string report(const SweepOptions& options, const FineScan& scan,
                   const std::vector<OpenSideVerdict>& verdicts, double total_s) {
  const auto by_closest = [](const auto& a, const auto& b) { return a.closest < b.closest; };
  const double closest = std::min_element(verdicts.begin(), verdicts.end(), by_closest)->closest;
  return fmt::format(
      "# Any length of the open side\n\n"
      "theta-scan with its default options on `{}` with {} random lengths d34 (seed {}), uniform over all "
      "values {:.6g} to {:.6g} that the curve takes, against a scan of the published kind at {} angles, {:g} "
      "times finer than 1°: from every branch with |d34(θ) − d34| < {:g} Newton's method starts. Solutions "
      "are up to reflection. Written by `scripts/sweep-open-side`.\n\n"
      "{}, {:.0f} s.\n\n{}\n"
      "The closest two solutions for one length differ in no distance by more than {:.1e} of the scene's "
      "size.\n\n## Lengths that differ\n\n{}",
      instance, verdicts.size(), options.seed, scan.shortest(), scan.longest(), options.angles,
      options.angles / 360.0, options.band, where_measured(), total_s, counts_table(verdicts), closest,
      differences(verdicts));
}

/// An interrupt ends the series before the length that it met.
std::vector<OpenSideVerdict> sweep_lengths(const SweepOptions& options, const FineScan& scan) {
  std::mt19937_64 random(options.seed);
  std::vector<OpenSideVerdict> verdicts;
  for (int i = 0; i < options.values; ++i) {
    const double share = static_cast<double>(random() >> 11U) * 0x1p-53;
    const double length = scan.shortest() + share * (scan.longest() - scan.shortest());
    const OpenSideVerdict verdict = check_open_side(scan, length, options.band);
    if (interrupted()) break;
    if (!verdict.agrees()) std::cerr << row(verdict);
    verdicts.push_back(verdict);
  }
  return verdicts;
}

int sweep(const SweepOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  AtomicFile out(options.out);
  const FineScan scan(load_instance(instance).problem, options.angles);
  const std::vector<OpenSideVerdict> verdicts = sweep_lengths(options, scan);
  const double total_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (!verdicts.empty()) out.commit(report(options, scan, verdicts, total_s));
  const auto agreeing =
      std::count_if(verdicts.begin(), verdicts.end(), [](const auto& verdict) { return verdict.agrees(); });
  std::cout << agreeing << " of " << verdicts.size() << " lengths agree; " << options.out << '\n';
  return agreeing == options.values ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return gcs::sweep_main(argc, argv, "open_side_sweep",
                         "Compares theta-scan with a fine scan for many lengths of the open side.",
                         add_options, sweep);
}
