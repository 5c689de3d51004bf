/// The tables of Hoffmann and Yuan on runs of invented figures.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "harness/drawings/svg_plot.hpp"
#include "harness/report/verdicts.hpp"
#include "harness/tables/table_run.hpp"
#include "harness/tables/table_writer.hpp"
#include "harness/tables/tables.hpp"
#include "harness/tests/approved.hpp"
#include "harness/tests/runs/stored_scenes.hpp"
#include "harness/tests/runs/toy_run.hpp"

using namespace gcs;

namespace {

Publication paper() { return load_publication("hoffmann-yuan-2000"); }

/// The printed solution as if it were computed, p4 moved up by `offset`.
RecordedSolution as_computed(const PrintedSolution& printed, double offset) {
  RecordedSolution solution;
  for (const PrintedPoint& point : printed.points)
    for (std::size_t axis = 0; axis < 3; ++axis)
      solution.points[point.name][axis] = std::strtod(point.printed[axis].c_str(), nullptr);
  solution.points["p4"][2] += offset;
  return solution;
}

/// Every other row of the paper's first twelve: one of each class.
CellRecord scan_cell(double offset) {
  CellRecord cell =
      toy::cell({"hoffmann-yuan", "theta-scan", {{"method", "published"}, {"dtheta", "1"}, {"delta", "0.2"}}},
                0, 0, 0.008);
  cell.counts.on_path.reset();
  cell.particulars = {{"coarse_solutions", 220}, {"refined_solutions", 24}};
  const Publication publication = paper();
  for (std::size_t i = 0; i < 12; i += 2)
    cell.solutions.push_back(as_computed(publication.solutions[i], offset));
  return cell;
}

RunFile pyramid_run(double offset) {
  RunFile run;
  run.environment = {"Toy CPU", "GNU 12", "-O3", "0123abc", 1};
  run.instances = {{"hoffmann-yuan",
                    "hoffmann-yuan.json",
                    "02ff",
                    13,
                    3,
                    {{{"p1", "L"}, "5.12863551744133", false}, {{"p3", "p4"}, "9.2", false}}},
                   {"octahedron", "octahedron.json", "00ff", 12, 3}};
  run.tables = {{"hoffmann-yuan", {"hoffmann-yuan", "octahedron"}}};
  CellRecord algebraic = toy::with_all(toy::cell({"octahedron", "cayley-menger", {}}, 0, 0, 1.5e-4), 4, 8);
  algebraic.particulars = {{"total_degree", 15}};
  run.cells = {scan_cell(offset), std::move(algebraic)};
  run.curves = {{"hoffmann-yuan", 9.15, {0, 90, 150}, {1.5, 12, 9.15}}};
  return run;
}

RunFile tangents_run() {
  RunFile run;
  run.environment.cpu = "Toy CPU";
  run.instances = {{"tangents-durand", "tangents-durand.json", "03ff", 4, 3},
                   {"tangents-fourfold", "tangents-fourfold.json", "04ff", 4, 3}};
  run.tables = {{"tangents", {"tangents-durand", "tangents-fourfold"}}};
  CellRecord simple = toy::with_all(toy::cell({"tangents-durand", "sphere-tangents", {}}, 0, 0, 2e-3), 4, 12);
  simple.solutions.resize(12);
  CellRecord followed = simple;
  followed.spec.given = {{"method", "published"}, {"system", "quadrics"}};
  followed.counts.paths = 64;
  followed.counts.at_infinity = 39;
  followed.counts.failed_paths = 2;
  CellRecord multiple =
      toy::with_all(toy::cell({"tangents-fourfold", "sphere-tangents", {}}, 0, 0, 3e-3), 3, 3);
  multiple.solutions.resize(3);
  multiple.solutions[1].multiplicity = 4;
  run.cells = {std::move(simple), std::move(followed), std::move(multiple)};
  return run;
}

/// One scan that finds all, one that does not, one of which nobody counts what there is.
RunFile scan_run() {
  RunFile run;
  run.environment.cpu = "Toy CPU";
  run.instances = {{"hoffmann-yuan", "hoffmann-yuan.json", "02ff", 13, 3}, {"k33", "k33.json", "05ff", 9, 2}};
  run.tables = {{"scan", {"hoffmann-yuan", "k33"}}};
  const auto scan = [](CellSpec spec, std::int64_t coarse, std::int64_t refined, std::uint64_t real) {
    CellRecord cell = toy::cell(std::move(spec), 0, 0, 2e-3);
    cell.work.evaluations = 180;
    cell.particulars = {
        {"driving_parameters", 1}, {"coarse_solutions", coarse}, {"refined_solutions", refined}};
    cell.proofs.emplace();
    cell.proofs->real = real;
    return cell;
  };
  const auto grid = [](const char* step, const char* delta) {
    return OptionMap{{"method", "published"}, {"step", step}, {"delta", delta}};
  };
  run.cells = {
      toy::with_all(toy::cell({"k33", "plan-scan", {}}, 0, 0, 1e-3), 3, 8),
      scan({"k33", "plan-scan", grid("5", "0.05")}, 7, 2, 2),
      scan({"k33", "plan-scan", grid("5", "0.5")}, 40, 3, 3),
      scan({"hoffmann-yuan", "theta-scan", {{"method", "published"}, {"dtheta", "5"}, {"delta", "0.05"}}}, 12,
           12, 3)};
  return run;
}

const TableCell& difference_of(const Table& table, std::size_t row) { return table.rows[row].cells.back(); }

}  // namespace

TEST_CASE("the tables of Hoffmann and Yuan are the approved ones", "[approved]") {
  const std::vector<Table> tables = build_pyramid(pyramid_run(0.004), paper());
  REQUIRE(tables.size() == 4);
  for (const Table& table : tables) check_approved(table.name + ".md", to_markdown(table));
}

TEST_CASE("the table of tangents is the approved one", "[approved]") {
  const std::vector<Table> tables = build_tangents(tangents_run(), paper());
  REQUIRE(tables.size() == 1);
  check_approved("tangents.md", to_markdown(tables.front()));
}

TEST_CASE("the table of scans is the approved one and counts what scans miss", "[approved]") {
  const std::vector<Table> tables = build_scan(scan_run(), paper());
  REQUIRE(tables.size() == 1);
  const Table& table = tables.front();
  CHECK_THAT(table.remarks.front(), Catch::StartsWith("1 of 2 scans miss"));
  const auto missed = [&](std::size_t row) { return table.rows[row].cells[4].text; };
  REQUIRE(table.rows.size() == 14);
  CHECK(missed(1) == "–");
  CHECK(missed(2) == "not measured");
  CHECK(missed(8) == "1");
  CHECK(missed(9) == "0");
  check_approved("scan.md", to_markdown(table));
}

TEST_CASE("of the 24 published solutions all agree but the known misprint, and that when it is corrected") {
  const Publication publication = paper();
  REQUIRE(publication.solutions.size() == 24);
  const Table table = build_pyramid_solutions(pyramid_run(0.004), publication);
  REQUIRE(table.rows.size() == 24);
  CHECK(std::count_if(table.rows.begin(), table.rows.end(),
                      [](const TableRow& row) { return row.cells.back().notes.empty(); }) == 23);
  REQUIRE(table.footnotes.size() == 1);
  CHECK_THAT(table.footnotes.front(), Catch::Contains("misprinted") && Catch::Contains("0.0040"));
}

TEST_CASE("a misprint is found by comparison and not by its number") {
  Publication publication = paper();
  for (PrintedSolution& solution : publication.solutions) solution.correction.reset();
  Table table = build_pyramid_solutions(pyramid_run(0.004), publication);
  REQUIRE(table.footnotes.size() == 1);
  CHECK_THAT(table.footnotes.front(), Catch::StartsWith("Differs"));

  publication = paper();
  for (PrintedSolution& solution : publication.solutions)
    for (PrintedPoint& point : solution.points)
      for (const PrintedPoint& right : solution.corrected)
        if (right.name == point.name) point = right;
  publication.solutions[4].points[2].printed[1] = "1.31";  // p3 of the fifth row
  table = build_pyramid_solutions(pyramid_run(0.004), publication);
  for (std::size_t row = 0; row < 24; ++row) CHECK(difference_of(table, row).notes.empty() == (row != 4));
  CHECK_FALSE(table.rows[4].cells[2].notes.empty());
  CHECK(table.rows[4].cells[1].notes.empty());
}

TEST_CASE("what differs by more than the rounding of two decimals says so in every row") {
  const Table table = build_pyramid_solutions(pyramid_run(0.0051), paper());
  for (std::size_t row = 0; row < 24; ++row) CHECK_FALSE(difference_of(table, row).notes.empty());
}

TEST_CASE("without a measurement the published solutions stand alone") {
  RunFile run = pyramid_run(0);
  run.cells.clear();
  const Table table = build_pyramid_solutions(run, paper());
  REQUIRE(table.rows.size() == 24);
  CHECK(difference_of(table, 0).text == "not measured");
}

TEST_CASE("the misprint breaks a distance of the paper's Table 1 and its correction does not") {
  const Publication publication = paper();
  const PrintedFigure* d23 = publication.find("table 1", "p2–p3", "hoffmann-yuan", "d_23");
  REQUIRE(d23 != nullptr);
  for (const PrintedSolution& solution : publication.solutions) {
    if (!solution.correction) continue;
    const auto distance_to_p2 = [&](const PrintedPoint& p3) {
      const RecordedSolution computed = as_computed(solution, 0);
      double square = 0;
      for (std::size_t axis = 0; axis < 3; ++axis)
        square +=
            std::pow(computed.points.at("p2")[axis] - std::strtod(p3.printed[axis].c_str(), nullptr), 2);
      return std::sqrt(square);
    };
    CHECK(std::abs(distance_to_p2(solution.points[2]) - d23->value) > 5);
    CHECK(std::abs(distance_to_p2(solution.corrected.front()) - d23->value) < 0.02);
  }
}

TEST_CASE("the figure is drawn from the stored run alone", "[approved]") {
  const RunFile run = pyramid_run(0.004);
  const std::vector<Drawing> drawings = draw_pyramid(run);
  REQUIRE(drawings.size() == 1);
  CHECK(drawings.front().name == "hoffmann-yuan-curve");
  check_approved("hoffmann-yuan-curve.svg", drawings.front().svg);
  const RunFile stored = parse_run_file(to_json_text(run), "run.json");
  CHECK(draw_pyramid(stored).front().svg == drawings.front().svg);
}

TEST_CASE("an axis covers its range from tick to tick") {
  for (const auto& [low, high] : {std::pair{1.6, 11.6}, {-0.03, 0.004}, {0.0, 1.0}, {-7e5, 1e6}}) {
    const PlotAxis axis = axis_over("", low, high);
    CHECK(axis.low <= low);
    CHECK(axis.high >= high);
    CHECK(low - axis.low < axis.tick);
    CHECK(axis.high - high < axis.tick);
    CHECK((high - low) / axis.tick <= 5 * (1 + 1e-12));
    CHECK((high - low) / axis.tick >= 2 * (1 - 1e-12));
  }
}

TEST_CASE("text in a plot is escaped and points outside of its axes are left out") {
  Plot plot;
  plot.x = {"a < b & c", 0, 1, 0.5};
  plot.y = {"y", 0, 1, 0.5};
  plot.series = {{"s", PlotMark::circle, {{0.5, 0.5}, {2, 0.5}, {0.5, -1}}}};
  const std::string svg = to_svg(plot);
  CHECK_THAT(svg, Catch::Contains("a &lt; b &amp; c"));
  std::size_t circles = 0;
  const std::string circle = "a2.2 2.2 0 1 0 4.4 0";
  for (std::size_t at = svg.find(circle); at != std::string::npos; at = svg.find(circle, at + 1)) ++circles;
  CHECK(circles == 2);  // the one inside, and the legend's
}

TEST_CASE("what is measured proves that the 24 solutions of the paper are all") {
  SilentMonitor monitor;
  TableRequest request;
  request.tables = {"hoffmann-yuan"};
  request.instances = {"hoffmann-yuan"};
  request.repetitions = 1;
  const RunFile run = run_tables(request, load_publications(), monitor);
  const StoredScene scene = stored_scene(load_instance("hoffmann-yuan"));
  const std::vector<Verdict> all = verdicts(run, run.instances.front(), &scene, load_publications());
  const auto real =
      std::find_if(all.begin(), all.end(), [](const Verdict& one) { return one.quantity == "real"; });
  REQUIRE(real != all.end());
  CHECK(real->printed == "24 (fixed frame)");
  CHECK(real->ours == "6");
  CHECK(real->our_standing == VerdictStanding::proven);
  CHECK(real->printed_standing == VerdictStanding::proven);
}
