/// A strategy that is added appears in all that is measured and shown, without a line of the harness.

#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "harness/instances/families.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/table_run.hpp"
#include "harness/tables/tables.hpp"
#include "solvers/interface/options.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/reduction/reduced_strategy.hpp"

namespace gcs {

StrategyEntry rcp_entry();
StrategyEntry plan_scan_entry();

namespace {

struct Newcomer {
  static constexpr std::string_view strategy = "newcomer";

  std::uint64_t seed = 1;
  int threads = 1;
  bool certify = false;
  std::optional<bool> reduce = {};
  int starts = 3;

  template <class Self, class Visitor>
  static void options(Self& self, Visitor&& option) {
    option("starts", self.starts, Range{1, 100}, "sketches to start from, each a tenth larger");
  }
};

/// Newton's method from the sketch.
class NewcomerStrategy final : public Strategy {
 public:
  explicit NewcomerStrategy(const Newcomer& asked) : starts_(asked.starts) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    if (scene.has_lines()) return "it places points, and the instance has lines";
    return std::nullopt;
  }

  SolveReport solve(const SolveRequest& request) override {
    const DistanceSystem system(request.scene);
    Eigen::VectorXd x = system.coordinates(*request.scene.sketch());
    SolveReport report;
    for (int start = 0; start < starts_; ++start) {
      if (refine(system, target_squares(request.scene), x).converged) {
        report.status = SolveStatus::complete;
        report.candidates = {{system.figure(x)}};
        return report;
      }
      x *= 1.1;
    }
    report.reason = "Newton's method does not converge from there";
    return report;
  }

 private:
  int starts_;
};

StrategyEntry newcomer_entry() {
  StrategyEntry entry = entry_of<NewcomerStrategy, Newcomer>();
  entry.summary = "Newton's method from the sketch";
  entry.needs_sketch = true;
  entry.accuracy_settings = {{{"starts", "1"}}};
  return entry;
}

}  // namespace

std::span<const StrategyEntry> all_strategies() {
  static const std::vector<StrategyEntry> entries{
      with_reduction(rcp_entry()), with_reduction(plan_scan_entry()), with_reduction(newcomer_entry())};
  return entries;
}

std::span<const LeftOutPart> left_out_parts() { return {}; }

}  // namespace gcs

using namespace gcs;

namespace {

struct NoMonitor final : Monitor {
  void progress(std::string_view, double) override {}
};

RunFile measured(const std::string& table, const std::vector<std::string>& instances) {
  TableRequest request;
  request.tables = {table};
  request.instances = instances;
  request.repetitions = 1;
  NoMonitor monitor;
  return run_tables(request, load_publications(), monitor);
}

/// The settings with which the newcomer was measured, as their options in words.
std::set<std::string> settings(const RunFile& run) {
  std::set<std::string> found;
  for (const CellRecord& cell : run.cells)
    if (cell.spec.strategy == "newcomer") found.insert(label_of(cell.spec));
  return found;
}

bool shows(const TableSet& set, const std::string& word) {
  const auto names_it = [&](const TableRow& row) { return row.label.find(word) != std::string::npos; };
  const bool in_tables = std::any_of(set.tables.begin(), set.tables.end(), [&](const Table& table) {
    return std::any_of(table.rows.begin(), table.rows.end(), names_it);
  });
  const bool in_drawings = std::any_of(set.drawings.begin(), set.drawings.end(), [&](const Drawing& drawing) {
    return drawing.svg.find(word) != std::string::npos;
  });
  return in_tables && in_drawings;
}

}  // namespace

TEST_CASE("the table of strategies is this program's") {
  CHECK(all_strategies().size() == 3);
  CHECK_THROWS(find_strategy("full-space"));
}

TEST_CASE("an added strategy is measured and shown by precision") {
  const RunFile run = measured("precision", {"octahedron"});
  const std::set<std::string> found = settings(run);
  CHECK(found.count("newcomer") == 1);
  CHECK(found.count("newcomer starts=1") == 1);
  CHECK(shows(build_tables(run, load_publications()), "newcomer"));
}

TEST_CASE("an added strategy is measured and shown by stability") {
  const RunFile run = measured("stability", find_family("near-miss")->members());
  CHECK(settings(run) == std::set<std::string>{"newcomer"});
  CHECK(shows(build_tables(run, load_publications()), "newcomer"));
}
