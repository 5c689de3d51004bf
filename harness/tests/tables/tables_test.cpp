#include "harness/tables/tables.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "harness/instances/instance_lookup.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/table_output.hpp"
#include "harness/tests/approved.hpp"
#include "harness/tests/runs/toy_run.hpp"
#include "solvers/counting/theoretical_counts.hpp"

using namespace gcs;

namespace {

Publication paper() { return load_publication("imbach-mathis-schreck-2016"); }

std::vector<Variant> variants_of_a_strategy_to_come() { return {{"full-space", {}}, {"to-come", {}}}; }

}  // namespace

TEST_CASE("the tables of a run are the approved ones", "[approved]") {
  const TableSet set = build_tables(toy::run_record(), load_publications());
  REQUIRE(set.tables.size() == 5);
  for (const Table& table : set.tables) check_approved(table.name + ".md", to_markdown(table));
  check_approved("measurements.md", to_markdown(set.measurements));
  CHECK(set.lines ==
        std::vector<std::string>{"table3: this version knows no such table",
                                 "hoffmann-yuan: not measured, none of its instances was asked for"});
}

TEST_CASE("tables do not depend on whether the run was stored") {
  const RunFile run = toy::run_record();
  const RunFile stored = parse_run_file(to_json_text(run), "run.json");
  const Publications papers = load_publications();
  CHECK(shown_on_terminal(build_tables(stored, papers)) == shown_on_terminal(build_tables(run, papers)));
}

TEST_CASE("no entry of any table is blank") {
  const TableSet set = build_tables(toy::run_record(), load_publications());
  for (const Table& table : set.tables) {
    for (const TableRow& row : table.rows) {
      CHECK((row.is_heading() || static_cast<int>(row.cells.size()) == table.column_count()));
      for (const TableCell& cell : row.cells) CHECK_FALSE(cell.text.empty());
    }
  }
}

TEST_CASE("table names are unique and every table measures something") {
  std::set<std::string_view> names;
  for (const TableKind& kind : table_kinds()) {
    CHECK(names.insert(kind.name).second);
    CHECK_FALSE(kind.variants().empty());
    CHECK_FALSE(kind.instances().empty());
  }
}

TEST_CASE("a table whose strategy is missing is unavailable and says which it is") {
  TableKind kind = *find_table("table1");
  CHECK_FALSE(why_unavailable(kind));
  kind.variants = variants_of_a_strategy_to_come;
  REQUIRE(why_unavailable(kind));
  CHECK(why_unavailable(kind)->find("to-come") != std::string::npos);
}

TEST_CASE("every published figure that an instance cites is the paper's") {
  const Publication publication = paper();
  for (const std::string& id : paper_instances()) {
    for (const PublishedFigure& cited : load_instance(id).published) {
      const auto found =
          std::any_of(publication.figures.begin(), publication.figures.end(), [&](const PrintedFigure& f) {
            return f.instance == id && f.row == cited.quantity && f.value == cited.value &&
                   f.convention == cited.convention;
          });
      INFO(id << " " << cited.quantity << " " << cited.value);
      CHECK(found);
    }
  }
}

TEST_CASE("figures that exceed proven bounds are marked with the reason") {
  const Publication publication = paper();
  const auto corrected = [&](const std::string& row, const std::string& id, const std::string& by) {
    const PrintedFigure* figure = publication.find("table 1", row, id, by);
    return figure != nullptr && figure->correction && !figure->correction->source.empty();
  };
  CHECK(corrected("complex", "octahedron", "HOM4PS-2.0"));
  CHECK(corrected("complex", "dodecagon", "HOM4PS-2.0"));
  CHECK(corrected("on path", "icosahedron", ""));
  CHECK_FALSE(corrected("complex", "disulfide", "HOM4PS-2.0"));
}

TEST_CASE("published numbers of complex solutions are marked as wrong where they exceed what there can be") {
  const Publication publication = paper();
  for (const std::string& id : paper_instances()) {
    const PrintedFigure* figure = publication.find("table 1", "complex", id, "HOM4PS-2.0");
    if (figure == nullptr) continue;
    const TheoreticalCounts counts = theoretical_counts(load_instance(id).problem);
    REQUIRE(counts.upper_limit());
    const Natural limit = counts.upper_limit()->all_signs();
    INFO(id << ": " << figure->printed << ", at most " << limit.decimal());
    CHECK(figure->correction.has_value() == (figure->value > limit.approximate()));
  }
}

TEST_CASE("numbers keep three significant digits and integers all") {
  CHECK(number_text(1097) == "1097");
  CHECK(number_text(0.0333333) == "0.0333");
  CHECK(number_text(1234.5) == "1234");
  CHECK(number_text(12.345) == "12.3");
  CHECK(duration_text(1.25) == "1.25 s");
  CHECK(duration_text(0.00425) == "4.25 ms");
  CHECK(duration_text(2.5e-4) == "250 µs");
  CHECK(duration_text(3776) == "3776 s");
}
