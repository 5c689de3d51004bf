#include "harness/runs/cell_timing.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "harness/tables/table_entries.hpp"
#include "harness/tests/instances/toy_scene.hpp"

using namespace gcs;

namespace {

/// Finds both classes of the toy scene, proves them, leaves one out, or gives up, as its option `answer` says.
/// Every solve leaves a line in `log`.
class ToyStrategy final : public Strategy {
 public:
  ToyStrategy(std::string answer, std::vector<std::string>& log) : answer_(std::move(answer)), log_(log) {}

  std::optional<std::string> why_unsupported(const SolveRequest&) const override { return std::nullopt; }

  SolveReport solve(const SolveRequest& request) override {
    log_.push_back(answer_);
    SolveReport report = toy::good_report(request.scene);
    report.work.iterations = answer_ == "changing" ? static_cast<std::int64_t>(log_.size()) : 10;
    if (answer_ == "wrong") {
      report.candidates = {report.candidates[0], report.candidates[2]};  // one class and its mirror image
      report.paths.front().crossings = {{0, 1}, {1, -1}};
    }
    report.paths.front().proven = answer_.starts_with("proven");
    if (answer_ == "proven of core") report.claim = Claim::on_path_of_core;
    if (answer_ == "none") {
      report.status = SolveStatus::gave_up;
      report.reason = "it is too hard";
    }
    return report;
  }

 private:
  std::string answer_;
  std::vector<std::string>& log_;
};

std::vector<std::string> solve_log;
std::vector<std::vector<CellRecord>> checkpoints;

StrategyEntry toy_entry(std::string_view name) {
  StrategyEntry entry;
  entry.name = name;
  entry.options = {{"answer", "right", "a word", "what it does"}};
  entry.make = [](const OptionMap& options) -> std::unique_ptr<Strategy> {
    return std::make_unique<ToyStrategy>(options.at("answer"), solve_log);
  };
  return entry;
}

class Silence final : public Monitor {
 public:
  void progress(std::string_view, double) override {}
};

/// Measures one cell for each answer; "" is the default.
std::vector<CellRecord> measure_answers(const std::vector<std::string>& answers,
                                        const TimingSettings& settings,
                                        const std::vector<CellRecord>& known = {},
                                        bool keeps_solutions = false, bool is_timed = true) {
  const Scene scene(toy::instance().problem);
  const StrategyEntry entry = toy_entry("toy");
  std::vector<CellTask> tasks;
  for (const std::string& answer : answers) {
    const OptionMap given = answer.empty() ? OptionMap{} : OptionMap{{"answer", answer}};
    tasks.push_back({{"toy", "toy", given}, &entry, &scene, keeps_solutions, is_timed});
  }
  Silence silence;
  solve_log.clear();
  checkpoints.clear();
  return time_cells(tasks, settings, known, silence, [](const auto& cells) { checkpoints.push_back(cells); });
}

TimingSettings repetitions(int count) {
  TimingSettings settings;
  settings.repetitions = count;
  return settings;
}

CellRecord counting(const std::string& strategy, OptionMap given, std::uint64_t on_path) {
  CellRecord record;
  record.spec = {"toy", strategy, std::move(given)};
  record.status = RunStatus::complete;
  record.counts.on_path = on_path;
  record.repetitions.resize(3);
  return record;
}

}  // namespace

TEST_CASE("right answers are timed as often as asked") {
  const auto cells = measure_answers({"", "right"}, repetitions(5));
  REQUIRE(cells.size() == 2);
  for (const CellRecord& cell : cells) {
    CHECK(cell.is_right());
    CHECK(cell.counts.on_path == 2u);
    REQUIRE(cell.repetitions.size() == 5);
    CHECK(cell.repetitions.front().wall_s > 0);
  }
}

TEST_CASE("what is not timed is solved once, and timed when a run is resumed for its time") {
  const auto untimed = measure_answers({""}, repetitions(5), {}, false, false);
  CHECK(untimed.front().is_right());
  CHECK(untimed.front().repetitions.empty());
  CHECK(solve_log.size() == 1);
  const auto timed = measure_answers({""}, repetitions(5), untimed);
  CHECK(timed.front().repetitions.size() == 5);
}

TEST_CASE("solutions are kept where they are wanted, also when a run without them is resumed") {
  const auto without = measure_answers({""}, repetitions(3));
  REQUIRE(without.front().is_right());
  CHECK(without.front().solutions.empty());
  const auto resumed = measure_answers({""}, repetitions(3), without, true);
  CHECK(resumed.front().solutions.size() == 2);
  const ProblemStatement& problem = toy::instance().problem;
  for (const RecordedSolution& solution : resumed.front().solutions)
    CHECK(solution.points.size() == problem.points.size());
  measure_answers({""}, repetitions(3), resumed, true);
  CHECK(solve_log.empty());
}

TEST_CASE("a cell keeps whether its answer proves S, of the whole scene") {
  const auto cells = measure_answers({"", "proven", "proven of core"}, repetitions(1));
  for (const CellRecord& cell : cells) REQUIRE(cell.is_right());
  CHECK_FALSE(cells[0].is_path_proven);
  CHECK(cells[1].is_path_proven);
  CHECK_FALSE(cells[2].is_path_proven);
}

TEST_CASE("a wrong answer is reported with its difference and without a time") {
  const auto cells = measure_answers({"", "wrong"}, repetitions(3));
  const CellRecord& wrong = cells.back();
  CHECK_FALSE(wrong.is_right());
  CHECK(wrong.repetitions.empty());
  CHECK_THAT(wrong.difference, Catch::Contains("instead of 2"));
  Table table;
  CHECK(time_entry(table, &wrong).text == "no time");
  CHECK(answer_entry(table, &wrong, on_path(&wrong)).text == "1");
  REQUIRE(table.footnotes.size() == 1);
  CHECK_THAT(table.footnotes.front(), Catch::Contains("instead of 2"));
}

TEST_CASE("an answer that changes between repetitions is wrong") {
  const auto cells = measure_answers({"", "changing"}, repetitions(3));
  CHECK_FALSE(cells.back().is_right());
  CHECK(cells.back().repetitions.empty());
}

TEST_CASE("a cell without an answer keeps its reason") {
  const auto cells = measure_answers({"", "none"}, repetitions(3));
  CHECK(cells.back().status == RunStatus::gave_up);
  CHECK(cells.back().reason == "it is too hard");
  CHECK(cells.back().repetitions.empty());
  Table table;
  CHECK(time_entry(table, &cells.back()).text == "gave up");
}

TEST_CASE("repetitions are interleaved, and no cell always follows the same one") {
  constexpr std::size_t rounds = 20;
  measure_answers({"", "same"}, repetitions(rounds));
  REQUIRE(solve_log.size() == 2 + 2 * rounds);
  std::set<std::string> first;
  for (std::size_t i = 0; i < solve_log.size(); i += 2) {
    CHECK(std::set<std::string>{solve_log[i], solve_log[i + 1]} == std::set<std::string>{"right", "same"});
    first.insert(solve_log[i]);
  }
  CHECK(first.size() == 2);
}

TEST_CASE("the number of repetitions follows the budget within its bounds") {
  TimingSettings settings;
  settings.limits.budget_s = 0;
  CHECK(measure_answers({""}, settings).front().repetitions.size() == 3);
  settings.limits.budget_s = 1e6;
  CHECK(measure_answers({""}, settings).front().repetitions.size() == 101);
}

TEST_CASE("cells are not run when the time for everything is used up") {
  TimingSettings settings;
  settings.limits.total_limit_s = 0;
  const auto cells = measure_answers({""}, settings);
  CHECK(cells.front().status == RunStatus::timed_out);
  CHECK_THAT(cells.front().reason, Catch::StartsWith("not run"));
  CHECK(solve_log.empty());
}

TEST_CASE("of a run that was stopped only the repetitions that are missing are made") {
  auto known = measure_answers({"", "same"}, repetitions(4));
  known.back().repetitions.resize(2);
  const auto cells = measure_answers({"", "same"}, repetitions(4), known);
  for (const CellRecord& cell : cells) CHECK(cell.repetitions.size() == 4);
  CHECK(cells.back().repetitions[1].wall_s == known.back().repetitions[1].wall_s);
  CHECK(solve_log == std::vector<std::string>{"same", "same"});
}

TEST_CASE("what is known of later cells is never missing from what is stored") {
  const auto known = measure_answers({"same"}, repetitions(2));
  const auto cells = measure_answers({"", "same"}, repetitions(2), known);
  CHECK(solve_log == std::vector<std::string>{"right", "right", "right"});
  REQUIRE_FALSE(checkpoints.empty());
  checkpoints.push_back(cells);
  for (const auto& stored : checkpoints) {
    const auto found = std::find_if(stored.begin(), stored.end(),
                                    [&](const CellRecord& cell) { return cell.spec == known[0].spec; });
    REQUIRE(found != stored.end());
    CHECK(found->repetitions.size() == 2);
    CHECK(stored.size() == 2);
  }
}

TEST_CASE("a plan is kept when a run goes on, and raised when more is asked for") {
  auto known = measure_answers({""}, repetitions(5));
  known.front().repetitions.resize(1);
  CHECK(measure_answers({""}, {}, known).front().repetitions.size() == 5);
  CHECK(measure_answers({""}, repetitions(3), known).front().repetitions.size() == 5);
  CHECK(measure_answers({""}, repetitions(7), known).front().repetitions.size() == 7);
  CHECK(solve_log.size() == 6);
}

TEST_CASE("a cell without an answer is not solved again, one that was interrupted is") {
  auto known = measure_answers({"", "none"}, repetitions(3));
  measure_answers({"", "none"}, repetitions(3), known);
  CHECK(solve_log.empty());
  known.back().status = RunStatus::interrupted;
  measure_answers({"", "none"}, repetitions(3), known);
  CHECK(solve_log == std::vector<std::string>{"none"});
}

TEST_CASE("what was too slow is solved again only when it may take longer") {
  auto known = measure_answers({"none"}, repetitions(3));
  known.front().status = RunStatus::timed_out;
  known.front().limit_s = 10;
  TimingSettings settings = repetitions(3);
  const auto solves = [&](std::optional<double> cell_limit_s) {
    settings.limits.cell_limit_s = cell_limit_s;
    measure_answers({"none"}, settings, known);
    return solve_log.size();
  };
  CHECK(solves(5) == 0);
  CHECK(solves(10) == 0);
  CHECK(solves(11) == 1);
  CHECK(solves({}) == 1);
  known.front().limit_s.reset();  // it was never run
  CHECK(solves(5) == 1);
}

TEST_CASE("strategies whose defaults disagree are all without a time") {
  std::vector<CellRecord> cells{counting("a", {}, 8), counting("b", {}, 7),
                                counting("a", {{"mode", "x"}}, 8)};
  note_differences(cells, {});
  for (const CellRecord& cell : cells) {
    CHECK(cell.difference == "The strategies disagree: a found 8, b found 7.");
    CHECK(cell.repetitions.empty());
  }
}

TEST_CASE("defaults are held to the literature and variants to the defaults") {
  std::vector<CellRecord> cells{counting("a", {}, 7), counting("a", {{"mode", "x"}}, 7),
                                counting("a", {{"mode", "y"}}, 9)};
  note_differences(cells, {{"toy", 8}});
  CHECK(cells[0].difference == "Found 7 on S instead of 8 (-1).");
  CHECK(cells[1].difference.empty());
  CHECK(cells[2].difference == "Found 9 on S instead of 7 (+2).");
}

TEST_CASE("who claims all real solutions has as many as there are on S") {
  std::vector<CellRecord> cells{counting("a", {}, 8), counting("all", {}, 0), counting("fewer", {}, 0)};
  for (CellRecord* cell : {&cells[1], &cells[2]}) cell->counts.on_path.reset();
  cells[1].counts.real_up_to_reflection = 18;
  cells[2].counts.real_up_to_reflection = 7;
  note_differences(cells, {});
  CHECK(cells[1].is_right());
  CHECK(cells[2].difference == "Found 7 real solutions, fewer than the 8 on S.");
  CHECK(cells[2].repetitions.empty());
}

TEST_CASE("variants alone are held to the literature") {
  std::vector<CellRecord> cells{counting("a", {{"mode", "x"}}, 7), counting("a", {{"mode", "y"}}, 8)};
  note_differences(cells, {{"toy", 8}});
  CHECK_FALSE(cells[0].is_right());
  CHECK(cells[1].is_right());
}
