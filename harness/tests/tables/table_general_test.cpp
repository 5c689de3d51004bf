/// The table of general scenes, from invented figures.

#include <algorithm>
#include <catch2/catch.hpp>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tables/table_writer.hpp"
#include "harness/tables/tables.hpp"
#include "harness/tests/approved.hpp"
#include "harness/tests/runs/toy_run.hpp"

using namespace gcs;

namespace {

CellRecord certified(CellRecord cell, Claim claim, RecordedProofs proofs) {
  cell.claim = claim;
  cell.proofs = proofs;
  return cell;
}

InstanceSummary summary(const std::string& id, const std::string& convention) {
  InstanceSummary instance{id, id + ".json", "00ff", 6, 3};
  instance.convention = convention;
  return instance;
}

/// One scene whose bound is met, and one without a bound; a strategy that was too slow, one that found some, one that
/// follows S, one that cannot do it and one that is wrong.
RunFile general_run() {
  RunFile run = toy::run_record();
  run.tables = {{"general", {"platform", "three-points-three-lines-angles"}}};
  run.instances = {summary("platform", "up to motion"),
                   summary("three-points-three-lines-angles", "up to reflection")};
  run.instances[0].limit = RecordedLimit{false, "40", {{}, {}, 1, "two bodies and six distances: a theorem"}};
  const auto solved = [](const std::string& id, const std::string& strategy, double seconds) {
    CellRecord cell = toy::cell({id, strategy, {}}, 0, 0, seconds);
    cell.counts.on_path.reset();
    return cell;
  };
  const std::string second = "three-points-three-lines-angles";
  run.cells = {
      certified(toy::with_all(solved("platform", "monodromy", 0.05), 2, 40), Claim::all_complex,
                {40, 2, true, true}),
      certified(toy::with_all(solved("platform", "polyhedral", 0.2), 2, 40), Claim::all_complex,
                {39, 2, false, false}),
      certified(solved("platform", "newton-multistart", 0.01), Claim::some_real, {2, 2, false, false}),
      toy::unsupported({"platform", "full-space", {}}),
      certified(toy::timed_out({second, "monodromy", {}}), Claim::all_complex, {0, 0, false, false}),
      certified(toy::with_all(solved(second, "polyhedral", 3), 78, 960), Claim::all_complex,
                {960, 78, false, false}),
      toy::wrong(toy::with_all(solved(second, "newton-multistart", 1), 70, 90)),
      certified(toy::cell({second, "full-space", {}}, 8, 0, 0.1), Claim::on_path, {8, 8, false, false}),
  };
  return run;
}

}  // namespace

TEST_CASE("the table of general scenes is the approved one", "[approved]") {
  const TableSet set = build_tables(general_run(), load_publications());
  REQUIRE(set.tables.size() == 1);
  check_approved("general.md", to_markdown(set.tables.front()));
}

TEST_CASE("the table of general scenes has external programs that were measured") {
  RunFile run = general_run();
  const std::size_t rows = build_tables(run, load_publications()).tables.front().rows.size();
  CellRecord cell = toy::with_all(toy::cell({"platform", "exec:./solver", {}}, 0, 0, 0.3), 2, 40);
  run.cells.push_back(certified(cell, Claim::all_complex, {40, 2, true, true}));
  const Table table = build_tables(run, load_publications()).tables.front();
  CHECK(table.rows.size() == rows + 1);
  CHECK(std::ranges::count(table.rows, "exec:solver", &TableRow::label) == 1);
}

TEST_CASE("known numbers of general scenes are those that their instances cite, in their conventions") {
  const Publication known = load_publication("general-scenes");
  const auto is_in_both = [&](const std::string& id, const std::string& quantity, double value,
                              const std::string& convention) {
    const PrintedFigure* figure = known.find("known", quantity, id, "");
    return figure != nullptr && figure->value == value && figure->convention == convention;
  };
  std::size_t cited = 0;
  for (const std::string& id : general_instances())
    for (const PublishedFigure& figure : load_instance(id).published) {
      CAPTURE(id, figure.quantity);
      ++cited;
      CHECK(is_in_both(id, figure.quantity, figure.value, figure.convention));
    }
  CHECK(cited == known.figures.size());
  for (const PrintedFigure& figure : known.figures) CHECK_FALSE(figure.remark.empty());
}

TEST_CASE("the table of general scenes has every shipped scene of that format") {
  for (const std::string& id : shipped_instances())
    if (load_instance(id).problem.is_general()) CHECK(std::ranges::count(general_instances(), id) == 1);
}
