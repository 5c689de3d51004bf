#include "harness/tables/table_writer.hpp"

#include <catch2/catch.hpp>

#include "harness/tests/approved.hpp"

using namespace gcs;

namespace {

/// Everything that a writer has to get right once: groups, headings, marks, and characters with a meaning.
Table toy_table() {
  Table table;
  table.name = "toy";
  table.caption = "Toys & their 100% δ_max";
  table.stub = "row";
  table.groups = {{"left", {"published", "ours"}}, {"right|side", {"published", "ours"}}};
  const int wrong = table.footnote("Known to be wrong: 72 > 64, says \"the bound\".");
  const int slow = table.footnote("Ended {early}, at 5 ± 1 µs.");
  table.rows = {
      {"counts", {}, {}},
      {"on S, up to reflection", {{"72", {wrong}}, {"64", {}}, {"–", {}}, {"a|b", {}}}, {}},
      {"times", {}, {}},
      {"rcp_fast", {{"0.06 s", {}}, {"2.13 ms ±3%", {slow, wrong}}, {"1, 2", {}}, {"a \\ b", {}}}, {slow}}};
  table.remarks = {"Ratio: ours / published.", "Cited: [I]."};
  return table;
}

}  // namespace

TEST_CASE("the writers' output is the approved one", "[approved]") {
  for (const TableFormat& format : table_formats()) {
    check_approved("toy." + std::string(format.extension), format.write(toy_table()));
  }
}

TEST_CASE("a table with one unnamed column a group has a single header line") {
  Table table;
  table.caption = "c";
  table.groups = {{"one", {""}}, {"two", {""}}};
  table.rows = {{"r", {{"1", {}}, {"2", {}}}, {}}};
  CHECK(to_markdown(table) == "### c\n\n|     | one | two |\n| :-- | --: | --: |\n| r   |   1 |   2 |\n");
  CHECK(to_csv(table) == "section,row,one,two,notes\n,r,1,2,\n");
}

TEST_CASE("the same footnote is numbered once") {
  Table table;
  CHECK(table.footnote("a") == 0);
  CHECK(table.footnote("b") == 1);
  CHECK(table.footnote("a") == 0);
}
