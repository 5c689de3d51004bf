/// The tables of graphs and their realisations on a run of invented figures.

#include <catch2/catch.hpp>

#include "harness/tables/tables.hpp"
#include "harness/tests/runs/toy_run.hpp"

using namespace gcs;

TEST_CASE("graphs of a run have a row for each number of points, whatever else the run has") {
  RunFile run;
  run.instances = {{"laman-6@3", "laman-6@3", "00ff", 9, 2},
                   {"g16a", "g16a.json", "01ff", 15, 3},
                   {"laman-6@4", "laman-6@4", "02ff", 9, 2}};
  run.cells = {toy::cell({"g16a", "monodromy", {}}, 8, 8, 1e-3)};
  const std::vector<Table> tables = build_realisations(run, {});
  REQUIRE(tables.size() == 1);
  CHECK(tables.front().name == "realisations-all");
  REQUIRE(tables.front().rows.size() == 1);
  CHECK(tables.front().rows.front().label == "6 points, in the plane");
  CHECK(tables.front().rows.front().cells.front().text == "2");
}
