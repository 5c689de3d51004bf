/// The program behind scripts/sweep-follow: gcs::follow against Newton's method for many random changes of the shipped
/// scenes. Exit code 1 when follow without proof says anything else than with it.

#include <fmt/format.h>

#include <array>
#include <iostream>
#include <string>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/sweeps/follow_check.hpp"
#include "harness/sweeps/sweep_main.hpp"

namespace {

using namespace gcs;

constexpr std::array parts{0.01, 0.05, 0.2};

struct SweepOptions {
  int changes = 1000;
  std::uint64_t seed = 1;
  std::vector<std::string> instances;
  std::string out;
};

void add_options(CLI::App& app, SweepOptions& options) {
  app.add_option("--changes", options.changes, "How many random changes of each scene and size")
      ->check(CLI::Range(1, 1'000'000))
      ->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of the changes")->capture_default_str();
  app.add_option("--instances", options.instances, "Shipped instances; all unless told")->delimiter(',');
  app.add_option("--out", options.out, "Markdown file for the results")->required();
}

struct Row {
  std::string instance;
  double part = 0;
  FollowTally tally;
};

void add(const FollowTally& more, FollowTally& sum) {
  sum.changes += more.changes;
  sum.reached += more.reached;
  sum.folds += more.folds;
  sum.undecided += more.undecided;
  sum.differs += more.differs;
  sum.fails += more.fails;
  sum.flips += more.flips;
  sum.elsewhere += more.elsewhere;
  sum.silent += more.silent;
  sum.proof_s += more.proof_s;
  sum.track_s += more.track_s;
}

std::string text_of(const Row& row) {
  const FollowTally& t = row.tally;
  return fmt::format("| {} | {:g} % | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.2f} | {:.2f} |\n",
                     row.instance, 100 * row.part, t.changes, t.reached, t.folds, t.undecided, t.differs,
                     t.fails, t.flips, t.elsewhere, t.silent, 1e3 * t.proof_s / t.changes,
                     1e3 * t.track_s / t.changes);
}

std::string report(const SweepOptions& options, const std::vector<Row>& rows) {
  std::string text = fmt::format(
      "# Figures that move with changing values\n\n"
      "`gcs::follow` from the real solutions on S of each scene, {} changes for each size (seed {}): every "
      "length, "
      "offset and angle times 1 + p·u, u uniform in [−1, 1]. *reached*, *folds*: proven by tubes; "
      "*undecided*: no "
      "proof. *differs*: follow without proof says something else. Newton's method from the old figure at "
      "the new "
      "values, undamped, as in CAD systems: of the reached ones it *fails* to settle, *flips* to a solution "
      "with "
      "another orientation of some points, or lands *elsewhere* without one; *silent*: it finds a solution "
      "where the "
      "figure folds before. Times: of one follow with and without proof, one core, mean. Written by "
      "`scripts/sweep-follow`.\n\n{}.\n\n"
      "| scene | p | changes | reached | folds | undecided | differs | Newton fails | flips | elsewhere | "
      "silent | ms "
      "proven | ms |\n| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |\n",
      options.changes, options.seed, where_measured());
  for (const double part : parts) {
    Row sum{"all", part, {}};
    for (const Row& row : rows)
      if (row.part == part) add(row.tally, sum.tally);
    text += text_of(sum);
  }
  for (const Row& row : rows) text += text_of(row);
  return text;
}

/// An interrupt ends the series before the row that it met.
std::vector<Row> sweep_scenes(const SweepOptions& options) {
  std::vector<Row> rows;
  for (const std::string& id : options.instances.empty() ? shipped_instances() : options.instances) {
    const Instance instance = load_instance(id);
    const std::vector<Figure> from = solutions_on_path(instance);
    if (from.empty()) continue;
    for (const double part : parts) {
      if (interrupted()) return rows;
      rows.push_back({id, part, tally_changes(instance, from, part, options.changes, options.seed)});
      std::cerr << text_of(rows.back());
    }
  }
  return rows;
}

int sweep(const SweepOptions& options) {
  AtomicFile out(options.out);
  const std::vector<Row> rows = sweep_scenes(options);
  FollowTally sum;
  for (const Row& row : rows) add(row.tally, sum);
  if (sum.changes > 0) out.commit(report(options, rows));
  std::cout << sum.changes << " changes; " << options.out << '\n';
  return sum.changes > 0 && sum.differs == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return gcs::sweep_main(argc, argv, "follow_sweep",
                         "Compares follow with Newton's method for many random changes.", add_options, sweep);
}
