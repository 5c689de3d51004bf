/// The table of the three ways on a run of invented figures.

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/tables/tables.hpp"
#include "harness/tests/runs/toy_run.hpp"

using namespace gcs;

namespace {

CellRecord followed(const std::string& id, OptionMap options) {
  CellRecord cell = toy::with_all(toy::cell({id, "system-paths", std::move(options)}, 0, 0, 2e-3), 3, 5);
  cell.counts.paths = 17;
  cell.counts.at_infinity = 4;
  cell.counts.failed_paths = 2;
  cell.particulars = {{"unknowns", 7},           {"terms", 31},        {"total_degree", 99},
                      {"homogeneous_bound", 43}, {"mixed_volume", 41}, {"extraneous_ends", 6}};
  return cell;
}

Table built() {
  RunFile run;
  run.instances = {{"octahedron", "octahedron.json", "00ff", 12, 3},
                   {"hoffmann-yuan", "hoffmann-yuan.json", "02ff", 13, 3}};
  CellRecord exact =
      toy::with_all(toy::cell({"octahedron", "cayley-menger", {{"method", "univariate"}}}, 0, 0, 3e-3), 4, 8);
  exact.particulars = {
      {"unknowns", 2}, {"total_degree", 15}, {"eliminated_degree", 14}, {"proven_real_solutions", 6}};
  CellRecord partial = followed("hoffmann-yuan", {{"system", "parametrised"}});
  partial.status = RunStatus::partial;
  partial.reason = "a path failed";
  partial.repetitions.clear();
  partial.warm_up_s = 5;
  run.cells = {followed("octahedron", {}), std::move(exact), std::move(partial)};
  const std::vector<Table> tables = build_three_ways(run, load_publication("hoffmann-yuan-2000"));
  REQUIRE(tables.size() == 1);
  return tables.front();
}

const TableRow& row(const Table& table, const std::string& part) {
  const auto found = std::ranges::find_if(
      table.rows, [&](const TableRow& one) { return one.label.find(part) != std::string::npos; });
  REQUIRE(found != table.rows.end());
  return *found;
}

std::vector<std::string> texts(const TableRow& row) {
  std::vector<std::string> all;
  for (const TableCell& cell : row.cells) all.push_back(cell.text);
  return all;
}

}  // namespace

TEST_CASE("a way has what is stated of it, what is counted of its system and what its paths did") {
  const Table table = built();
  const std::vector<std::string> quartics = texts(row(table, "from mixed cells"));
  REQUIRE(static_cast<int>(quartics.size()) == table.column_count());
  // Finite are those that neither failed nor are infinite.
  CHECK(std::vector<std::string>(quartics.begin(), quartics.end() - 1) ==
        std::vector<std::string>{"64", "7", "31", "99", "43", "41", "17", "11", "6", "4", "5", "3"});
}

TEST_CASE("a polynomial after elimination has a degree, and the system before it the rest") {
  const Table table = built();
  const std::vector<std::string> one = texts(row(table, "one polynomial")),
                                 two = texts(row(table, "two determinants"));
  CHECK(one[1] == "–");
  CHECK(one[3] == "14");
  CHECK(two[1] == "2");
  CHECK(two[3] == "15");
  CHECK(two.back() == "not measured");
  CHECK(std::ranges::any_of(table.remarks, [](const std::string& remark) {
    return remark.find("has 6 real roots") != std::string::npos;
  }));
}

TEST_CASE("what a partial answer counted is shown, with the reason") {
  const Table table = built();
  const TableRow& parametrised = row(table, "(8) and (9)");
  CHECK(parametrised.cells[3].text == "99");
  CHECK(parametrised.cells.back().text == "5 s (1 run)");
  REQUIRE_FALSE(parametrised.cells[3].notes.empty());
  CHECK_THAT(table.footnotes[static_cast<std::size_t>(parametrised.cells[3].notes.front())],
             Catch::Contains("a path failed"));
}

TEST_CASE("problems that the run does not have are left out") {
  const Table table = built();
  const auto headings =
      std::ranges::count_if(table.rows, [](const TableRow& one) { return one.is_heading(); });
  CHECK(headings == 2);
}
