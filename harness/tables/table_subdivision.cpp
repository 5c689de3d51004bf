/// Branch and prune over boxes, which Hoffmann and Yuan ask for at the end of section 4.4: what interval Newton alone
/// takes, what each equation and what linear programs spare, and what other methods with a proof take.

#include <fmt/format.h>

#include <array>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// A tenth of the default: enough to show which does not end. An answer that is partial, as it is beside
/// multiple solutions, is that of an experiment then.
constexpr const char* most_boxes = "1000000";

const std::vector<std::string>& line_instances() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> all = tangents_instances();
    all.emplace_back("hoffmann-yuan");
    return all;
  }();
  return ids;
}

/// A way to solve, and the label of its rows.
struct SubdivisionMethod {
  const char* label;
  Variant variant;
};

const std::array<SubdivisionMethod, 6>& subdivision_ways() {
  static const std::array<SubdivisionMethod, 6> all{{
      {"interval Newton", {"box-subdivision", {{"max_boxes", most_boxes}, {"reduction", "none"}}}},
      {"and each equation", {"box-subdivision", {{"max_boxes", most_boxes}, {"reduction", "box"}}}},
      {"and linear programs", {"box-subdivision", {{"max_boxes", most_boxes}}}},
      {"plan-scan", {"plan-scan", {}, {}, line_instances()}},
      {"theta-scan", {"theta-scan", {}, {"hoffmann-yuan"}}},
      {"sphere-tangents", {"sphere-tangents", {}, tangents_instances()}},
  }};
  return all;
}

/// What a column counts, under the names that strategies have for it.
struct Counter {
  const char* head;
  std::array<const char*, 2> names;
};

constexpr std::array counted_columns{
    Counter{"boxes or cells", {"boxes", "cells"}},
    Counter{"Krawczyk tests", {"krawczyk_tests", "boxes_tested"}},
    Counter{"linear programs", {"linear_programs", ""}},
    Counter{"undecided", {"undecided_boxes", "undecided_pieces"}},
};

/// What a cell counted, whether it ended or gave up.
TableCell counter_entry(const CellRecord* cell, const Counter& counter) {
  for (const char* name : counter.names)
    if (const auto count = particular(cell, name)) return {number_text(*count), {}};
  return empty_entry();
}

std::optional<double> real_solutions(const CellRecord* cell) {
  return cell == nullptr ? std::nullopt : number(cell->counts.real_up_to_reflection);
}

/// Of one that gave up, how long it took to.
TableCell whole_time_entry(Table& table, const CellRecord* cell) {
  TableCell entry = time_entry(table, cell);
  const bool gave_up =
      cell != nullptr && (cell->status == RunStatus::partial || cell->status == RunStatus::gave_up);
  if (gave_up) entry.text = fmt::format("{} (1 run)", duration_text(cell->warm_up_s));
  return entry;
}

TableRow row_of(Table& table, const SubdivisionMethod& way, const CellRecord* cell) {
  TableRow row{way.label, {}, {}};
  row.cells.push_back(answer_entry(table, cell, real_solutions(cell)));
  const auto proven = proven_real(cell);
  row.cells.push_back(proven ? TableCell{number_text(*proven), {}} : empty_entry());
  for (const Counter& counter : counted_columns) row.cells.push_back(counter_entry(cell, counter));
  row.cells.push_back(whole_time_entry(table, cell));
  return row;
}

}  // namespace

const std::vector<std::string>& subdivision_instances() {
  static const std::vector<std::string> ids{"k33",
                                            "prism",
                                            "octahedron",
                                            "octahedron-cyclohexane",
                                            "g16a",
                                            "disulfide",
                                            "g160",
                                            "dodecagon",
                                            "hoffmann-yuan",
                                            "tangents-durand",
                                            "tangents-12-real",
                                            "tangents-equal-radii",
                                            "tangents-fourfold"};
  return ids;
}

std::vector<Variant> subdivision_variants() {
  std::vector<Variant> variants;
  for (const SubdivisionMethod& way : subdivision_ways()) variants.push_back(way.variant);
  return variants;
}

std::vector<Table> build_subdivision(const RunFile& run, const Publication&) {
  Table table;
  table.name = "subdivision";
  table.caption = "Branch and prune over boxes: interval Newton, and what spares boxes";
  table.groups = {{"real solutions", {"all", "proven"}}, {"", {}}};
  for (const Counter& counter : counted_columns) table.groups.back().columns.emplace_back(counter.head);
  table.groups.back().columns.emplace_back("time");
  for (const InstanceSummary& instance : run.instances) {
    table.rows.push_back({instance.id, {}, {}});
    for (const SubdivisionMethod& way : subdivision_ways())
      if (way.variant.is_for(instance.id))
        table.rows.push_back(row_of(table, way, run.find(way.variant.on(instance.id))));
  }
  table.remarks = {
      fmt::format(
          "box-subdivision, up to {} boxes: interval Newton is reduction=none, Krawczyk's operator and "
          "bisection alone; reduction=box narrows by each equation too; reduction=linear, the default, by "
          "linear programs over all equations too. plan-scan and theta-scan subdivide angles in cells, of "
          "each of which they test the boxes of points.",
          most_boxes),
      "all: so many real solutions the strategy claims to be all, up to reflection; proven: so many "
      "certificates "
      "prove to exist and to be real. Next to multiple solutions boxes stay undecided, and the answer is "
      "partial.",
      fmt::format("Times: median of interleaved repetitions; {}. Ours: {}.", spread_remark,
                  run.environment.cpu)};
  return {table};
}

}  // namespace gcs
