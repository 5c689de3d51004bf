#include "harness/comparing/compare.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <utility>

#include "harness/comparing/table_compare.hpp"
#include "harness/tables/table_writer.hpp"
#include "harness/tests/approved.hpp"
#include "harness/tests/runs/toy_run.hpp"

using namespace gcs;

namespace {

constexpr double confidence = 0.95, margin = 0.1;

Comparison compared(const RunFile& before, const RunFile& after) {
  return compare_runs(before, after, {confidence, margin});
}

/// One cell, measured in times of a log-normal distribution about `median_s`.
CellRecord timed_cell(int number, double median_s, int repetitions, std::mt19937_64& random) {
  CellRecord record = toy::cell({"octahedron", "rcp", {{"seed", std::to_string(number)}}}, 4, 10, 1);
  record.repetitions.clear();
  std::lognormal_distribution<double> noise(0, 0.2);
  for (int i = 0; i < repetitions; ++i) {
    const double seconds = median_s * noise(random);
    record.repetitions.push_back({.wall_s = seconds, .cpu_s = seconds});
  }
  return record;
}

RunFile run_of(std::vector<CellRecord> cells) {
  RunFile run = toy::run_record();
  run.cells = std::move(cells);
  return run;
}

RunFile run_of_cells(int cells, double median_s, int repetitions, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<CellRecord> records;
  for (int i = 0; i < cells; ++i) records.push_back(timed_cell(i, median_s, repetitions, random));
  return run_of(std::move(records));
}

std::ptrdiff_t count(const Comparison& comparison, Pace pace) {
  return std::count_if(comparison.times.begin(), comparison.times.end(),
                       [&](const TimeChange& change) { return change.pace == pace; });
}

/// The verdict on the only answer that `change` makes differ.
template <typename Change>
ChangeVerdict verdict_on(Change change) {
  const RunFile before = run_of({toy::cell({"octahedron", "rcp", {}}, 4, 33, 1e-3)});
  RunFile after = before;
  change(after.cells.front());
  const Comparison there = compared(before, after);
  const Comparison back = compared(after, before);
  REQUIRE(there.answers.size() == 1);
  REQUIRE(back.answers.size() == 1);
  const ChangeVerdict verdict = there.answers.front().verdict;
  CHECK(there.has_regressed() == (verdict == ChangeVerdict::worse));
  CHECK(back.has_regressed() == (verdict == ChangeVerdict::better));
  return verdict;
}

}  // namespace

TEST_CASE("a run has not changed from itself") {
  const RunFile run = toy::run_record();
  const Comparison comparison = compared(run, run);
  CHECK(comparison.setup.empty());
  CHECK(comparison.answers.empty());
  CHECK(comparison.work.empty());
  CHECK(comparison.only_before.empty());
  CHECK(comparison.only_after.empty());
  CHECK(count(comparison, Pace::slower) + count(comparison, Pace::faster) == 0);
  CHECK_FALSE(comparison.has_regressed());
}

TEST_CASE("an answer that is further from right is worse, and its reverse better") {
  CHECK(verdict_on([](CellRecord& cell) { cell.status = RunStatus::gave_up; }) == ChangeVerdict::worse);
  CHECK(verdict_on([](CellRecord& cell) { cell.status = RunStatus::partial; }) == ChangeVerdict::worse);
  CHECK(verdict_on([](CellRecord& cell) { cell.difference = "Found 4 on S instead of 5."; }) ==
        ChangeVerdict::worse);
  CHECK(verdict_on([](CellRecord& cell) { cell.counts.on_path = 3; }) == ChangeVerdict::worse);
  CHECK(verdict_on([](CellRecord& cell) { cell.counts.on_path = 5; }) == ChangeVerdict::better);
  CHECK(verdict_on([](CellRecord& cell) { cell.counts.on_path.reset(); }) == ChangeVerdict::worse);
  CHECK(verdict_on([](CellRecord& cell) { cell.counts.generic = 8; }) == ChangeVerdict::better);
  CHECK(verdict_on([](CellRecord& cell) { cell.counts.failed_paths = 1; }) == ChangeVerdict::worse);
  CHECK(verdict_on([](CellRecord& cell) { cell.counts.paths = 1; }) == ChangeVerdict::different);
}

TEST_CASE("proofs, claims and accuracy are compared") {
  std::vector<CellRecord> cells{toy::cell({"octahedron", "rcp", {}}, 4, 33, 1e-3)};
  cells[0].claim = Claim::all_real;
  cells[0].proofs = RecordedProofs{8, 4, true, true};
  cells[0].accuracy = Accuracy{4, 0, 0, 1e-16, 1e-16, 10, 1};
  std::vector<CellRecord> changed = cells;
  changed[0].claim = Claim::on_path;
  changed[0].proofs = RecordedProofs{7, 4, false, true};
  changed[0].accuracy = Accuracy{3, 1, 1, 1e-9, 1e-16, 10, 1e6};
  const Comparison comparison = compared(run_of(cells), run_of(changed));
  std::vector<std::string> what;
  for (const AnswerChange& change : comparison.answers) {
    CHECK(change.verdict == ChangeVerdict::worse);
    what.push_back(change.changed.what);
  }
  // Spurious solutions make the answer wrong, which is said as its status.
  CHECK(what == std::vector<std::string>{"status", "claim", "classes proven", "all complex proven",
                                         "reference solutions met", "solutions missed", "spurious solutions",
                                         "largest error, relative to the scene's size"});
}

TEST_CASE("an answer that is right now is no regression for being fewer") {
  RunFile before = run_of({toy::cell({"octahedron", "rcp", {}}, 5, 33, 1e-3)});
  before.cells[0].difference = "Found 5 on S instead of 4 (+1).";
  const RunFile after = run_of({toy::cell({"octahedron", "rcp", {}}, 4, 33, 1e-3)});
  const Comparison comparison = compared(before, after);
  REQUIRE(comparison.answers.size() == 2);
  CHECK(comparison.answers[0].verdict == ChangeVerdict::better);
  CHECK(comparison.answers[1].verdict == ChangeVerdict::different);
  CHECK_FALSE(comparison.has_regressed());
}

TEST_CASE("accuracies against different references are not compared") {
  RunFile before = run_of({toy::cell({"octahedron", "rcp", {}}, 4, 33, 1e-3)});
  before.cells[0].accuracy = Accuracy{20, 0, 0, 1e-16, 1e-16, 10, 0.1};
  RunFile after = before;
  after.cells[0].accuracy->met = 18;
  CHECK(compared(before, after).has_regressed());
  after.instances[0].reference = "18 solutions, proven in this run";
  CHECK_FALSE(compared(before, after).has_regressed());
}

TEST_CASE("errors that the condition explains may differ") {
  RunFile before = run_of({toy::cell({"octahedron", "rcp", {}}, 4, 33, 1e-3)});
  before.cells[0].accuracy = Accuracy{4, 0, 0, 1e-16, 1e-16, 10, 0.1};
  RunFile after = before;
  after.cells[0].accuracy->largest_error = 9e-15;
  after.cells[0].accuracy->largest_quotient = 9;
  CHECK(compared(before, after).answers.empty());
}

TEST_CASE("work that differs is named with both numbers") {
  const RunFile before = toy::run_record();
  RunFile after = before;
  after.cells[0].work.iterations = 32;
  after.cells[0].particulars = {{"candidates", 7}};
  RunFile with_fewer = after;
  with_fewer.cells[0].particulars = {{"candidates", 5}};
  const Comparison comparison = compared(before, after);
  REQUIRE(comparison.work.size() == 1);
  CHECK(comparison.work[0].changed.what == "iterations");
  CHECK(comparison.work[0].changed.before == "31");
  CHECK(comparison.work[0].changed.after == "32");
  CHECK(compared(after, with_fewer).work.size() == 1);
  CHECK_FALSE(comparison.has_regressed());
}

TEST_CASE("cells of one run alone, and those left out for want of time, are not compared") {
  const RunFile before = toy::run_record();
  RunFile after = before;
  CellRecord& left_out = after.cells[5];
  left_out.status = RunStatus::timed_out;
  left_out.reason = "not run";
  left_out.repetitions.clear();
  after.cells.erase(after.cells.begin());
  const Comparison comparison = compared(before, after);
  CHECK(comparison.only_before == std::vector<CellSpec>{before.cells[0].spec, before.cells[5].spec});
  CHECK(comparison.only_after.empty());
  CHECK(compared(after, before).only_after == comparison.only_before);
  CHECK(comparison.answers.empty());
}

TEST_CASE("instances with other content are not compared, and said so") {
  const RunFile before = toy::run_record();
  RunFile after = before;
  after.instances[0].fingerprint = "another";
  after.cells[0].counts.on_path = 3;
  const Comparison comparison = compared(before, after);
  CHECK(comparison.answers.empty());
  REQUIRE(comparison.setup.size() == 1);
  CHECK_THAT(comparison.setup[0].what, Catch::Contains("octahedron"));
  CHECK(comparison.setup[0].after == "another");
}

TEST_CASE("what a run was made with is compared") {
  const RunFile before = toy::run_record();
  RunFile after = before;
  after.environment.commit = "9876fed";
  after.environment.flags = "-O2";
  after.sessions.back().cell_limit_s.reset();
  std::vector<std::string> what;
  for (const Changed& changed : compared(before, after).setup) what.push_back(changed.what);
  CHECK(what == std::vector<std::string>{"flags", "commit", "limit of one solve"});
}

TEST_CASE("the interval of a ratio holds as often as it says") {
  const auto missed = [](auto noise, int before_runs, int after_runs, double wanted) {
    constexpr double ratio = 1.5;  // of the medians: both samples have one distribution but for this factor
    std::mt19937_64 random(7);
    constexpr int trials = 4000;
    int misses = 0;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> before, after;
      for (int i = 0; i < before_runs; ++i) before.push_back(noise(random));
      for (int i = 0; i < after_runs; ++i) after.push_back(ratio * noise(random));
      const MedianRatio found = median_ratio(before, after, wanted);
      REQUIRE(found.confidence >= wanted);
      misses += found.low > ratio || found.high < ratio;
    }
    return static_cast<double>(misses) / trials;
  };
  // Log-normal times, and times that are mostly alike and sometimes far longer.
  const auto even = [](auto& random) { return std::lognormal_distribution<double>(0, 0.3)(random); };
  const auto skewed = [](auto& random) { return 1 + std::exponential_distribution<double>(3)(random); };
  // Of 4000 trials three standard deviations of chance are 1.1 % at 5 %, and 0.5 % at 1 %.
  for (const auto& [runs, more] : {std::pair{11, 17}, {25, 25}, {101, 40}}) {
    CAPTURE(runs, more);
    CHECK(missed(even, runs, more, 0.95) <= 0.061);
    CHECK(missed(skewed, runs, more, 0.95) <= 0.061);
    CHECK(missed(even, runs, more, 0.99) <= 0.015);
    CHECK(missed(skewed, runs, more, 0.99) <= 0.015);
  }
}

TEST_CASE("the interval of a ratio holds for times of two speeds, which are not the same ones in both runs") {
  std::mt19937_64 random(7);
  const auto times = [&](double usual, double other) {
    std::bernoulli_distribution is_usual(0.51);
    std::vector<double> all;
    for (int i = 0; i < 51; ++i) all.push_back(is_usual(random) ? usual : other);
    return all;
  };
  int misses = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const MedianRatio found = median_ratio(times(1.2, 1), times(1.2, 1.44), 0.95);
    misses += found.low > 1 || found.high < 1;
  }
  CHECK(misses <= 4000 * 0.061);
}

TEST_CASE("the interval of the ratio of equal medians is made of theirs") {
  std::vector<double> times;
  times.reserve(25);
  for (int i = 1; i <= 25; ++i) times.push_back(std::exp(0.01 * i));
  const MedianInterval one = median_interval(times, 0.99);
  const MedianRatio ratio = median_ratio(times, times, 0.99 * 0.99);
  CHECK(ratio.ratio == 1);
  CHECK(ratio.high == one.high / one.low);
  CHECK(ratio.low == one.low / one.high);
  CHECK(ratio.confidence == one.confidence * one.confidence);
}

TEST_CASE("of many cells that have not changed hardly ever one is called slower") {
  constexpr int cells = 200, repetitions = 25;
  int called = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RunFile before = run_of_cells(cells, 1e-3, repetitions, 2 * seed);
    const RunFile after = run_of_cells(cells, 1e-3, repetitions, 2 * seed + 1);
    const Comparison comparison = compare_runs(before, after, {confidence, 0});
    REQUIRE(comparison.times.size() == cells);
    called += comparison.has_regressed() ? 1 : 0;
  }
  CHECK(called <= 3);  // 20 comparisons of which one in 20 may
}

TEST_CASE("times that have grown by more than the margin are slower, and by less are not") {
  const RunFile before = run_of_cells(10, 1e-3, 101, 1);
  const auto with_times = [](double median_s) { return run_of_cells(10, median_s, 101, 2); };
  CHECK(count(compared(before, with_times(1.5e-3)), Pace::slower) == 10);
  CHECK(compared(before, with_times(1.5e-3)).has_regressed());
  CHECK(count(compared(before, with_times(0.6e-3)), Pace::faster) == 10);
  CHECK_FALSE(compared(before, with_times(0.6e-3)).has_regressed());
  CHECK(count(compared(before, with_times(1.05e-3)), Pace::slower) == 0);
  CHECK(count(compare_runs(before, with_times(1e-3), {confidence, 0.3}), Pace::alike) == 10);
}

TEST_CASE("on another processor a slower time is no regression") {
  const RunFile before = run_of_cells(3, 1e-3, 101, 1);
  RunFile after = run_of_cells(3, 2e-3, 101, 2);
  REQUIRE(compared(before, after).has_regressed());
  after.environment.cpu = "another";
  CHECK(count(compared(before, after), Pace::slower) == 3);
  CHECK_FALSE(compared(before, after).has_regressed());
}

TEST_CASE("what waits for the machine and takes no more of its time is not slower") {
  const RunFile before = run_of_cells(3, 1e-3, 101, 1);
  RunFile after = run_of_cells(3, 2e-3, 101, 2);
  for (CellRecord& cell : after.cells)
    for (Timing& repetition : cell.repetitions) repetition.cpu_s /= 2;
  CHECK(count(compared(before, after), Pace::undecided) == 3);
  CHECK(count(compared(after, before), Pace::undecided) == 3);
  for (CellRecord& cell : after.cells)
    for (Timing& repetition : cell.repetitions) repetition.prepare_s += 2e-3;
  CHECK(count(compared(before, after), Pace::slower) == 3);
}

TEST_CASE("three repetitions tell nothing of times") {
  const Comparison comparison = compared(run_of_cells(5, 1e-3, 3, 1), run_of_cells(5, 1, 101, 2));
  CHECK(count(comparison, Pace::too_few_runs) == 5);
}

TEST_CASE("the tables of a comparison are the approved ones", "[approved]") {
  std::mt19937_64 random(3);
  RunFile before = toy::run_record();
  RunFile after = before;
  after.started = "2026-01-03T03:04:05Z";
  after.sessions.front().load_average = {{3.5, 2, 1}};
  after.environment.commit = "9876fed";
  after.cells[0] = timed_cell(0, 1e-3, 25, random);
  before.cells[0] = timed_cell(0, 2e-3, 25, random);
  after.cells[2].counts.on_path = 3;
  after.cells[2].work.iterations = 30;
  after.cells.pop_back();
  const ComparisonTables shown = build_comparison(compared(before, after), "before", "after");
  REQUIRE(shown.tables.size() == 5);
  for (const Table& table : shown.tables) {
    check_approved(table.name + ".md", to_markdown(table));
    for (const TableRow& row : table.rows) {
      CHECK(static_cast<int>(row.cells.size()) == table.column_count());
      for (const TableCell& cell : row.cells) CHECK_FALSE(cell.text.empty());
    }
  }
  CHECK(shown.lines == std::vector<std::string>{
                           "Answers of 8 cells in both runs: 1 worse, 0 better, 0 otherwise different.",
                           "Times of 7 cells: 0 slower, 1 faster, 0 alike, 0 undecided, 6 too few runs.",
                           "B has regressed."});
}
