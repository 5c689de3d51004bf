/// What the text of Algorithms 1 to 4 of Imbach, Mathis, Schreck needs, and what changing the plan is worth.

#include <fmt/format.h>

#include <array>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// What rcp's options call the places of the text that are mended.
constexpr std::array<const char*, 5> deviations{"measure", "shift", "direction", "restoring", "turning"};

/// Several times what S takes on any shipped instance where it closes: who makes more is stuck.
constexpr const char* most_steps = "200000";

Variant as_published(OptionMap given) {
  given.emplace("mode", "paper");
  given.emplace("max_steps", most_steps);
  return {"rcp", std::move(given)};
}

/// A row: what of the text is followed to the letter, and how it is asked for.
struct Reading {
  std::string label;
  Variant variant;
};

std::vector<Reading> readings() {
  std::vector<Reading> all{{"nothing", as_published({})}};
  for (const char* deviation : deviations)
    all.push_back({fmt::format("{} alone", deviation), as_published({{deviation, "printed"}})});
  all.push_back({"everything", as_published({{"as", "printed"}})});
  for (const char* deviation : deviations)
    all.push_back({fmt::format("everything but {}", deviation),
                   as_published({{"as", "printed"}, {deviation, "mended"}})});
  return all;
}

/// "closed", or a word for another end with its reason below.
TableCell end_entry(Table& table, const CellRecord* cell) {
  if (cell != nullptr && cell->is_right()) return {"closed", {}};
  return time_entry(table, cell);
}

/// Also of a path that does not close: what it met before.
TableCell so_far(std::optional<double> value) {
  return value ? TableCell{number_text(*value), {}} : empty_entry();
}

void add_path_entries(Table& table, TableRow& row, const CellRecord* cell) {
  row.cells.push_back(end_entry(table, cell));
  row.cells.push_back(so_far(on_path(cell)));
  row.cells.push_back(so_far(work_count(cell, &WorkCounters::iterations)));
  row.cells.push_back(so_far(cell == nullptr ? std::nullopt : cell->work.smallest_step));
}

/// A row for each reading under each instance; `add_more` fills the columns after those of the path.
template <class AddMore>
void add_readings(Table& table, const RunFile& run, const std::vector<Reading>& all,
                  const AddMore& add_more) {
  for (const InstanceSummary& instance : run.instances) {
    table.rows.push_back({instance.id, {}, {}});
    for (const Reading& reading : all) {
      const CellRecord* cell = run.find(reading.variant.on(instance.id));
      TableRow row{reading.label, {}, {}};
      add_path_entries(table, row, cell);
      add_more(cell, row);
      table.rows.push_back(std::move(row));
    }
  }
}

std::vector<Variant> variants_of(const std::vector<Reading>& all) {
  std::vector<Variant> variants;
  for (const Reading& reading : all) variants.push_back(reading.variant);
  return variants;
}

const std::vector<std::string> path_columns{"end", "on S", "iterations", "smallest δ"};

const Variant proof_of_s{"full-space", {{"mode", "certified"}}};

struct Hypothesis {
  const char* label;
  const char* failures;  ///< rcp's count of them
};

constexpr std::array hypotheses{
    Hypothesis{"(h2) the support of positive lengths is compact", "open_sides"},
    Hypothesis{"(h3) no two lengths are one function of t", "equal_lengths"},
    Hypothesis{"(h4) the second point's length stays positive", "vanishing_first_lengths"},
    Hypothesis{"(h5) no two lengths of an instruction vanish together", "vanishing_pairs"},
    Hypothesis{"(h6) nor one beside a driving parameter", "vanishing_beside_driven"},
    Hypothesis{"(h7) the sketch is further than α from boundary configurations", "near_boundary_at_sketch"},
};

Table hypotheses_table(const RunFile& run) {
  Table table;
  table.name = "hypotheses";
  table.caption = "The hypotheses of section 3.1 and 4.3: which hold";
  for (const InstanceSummary& instance : run.instances) table.groups.push_back({instance.id, {""}});
  TableRow regular{"(h1) S is regular", {}, {}};
  for (const InstanceSummary& instance : run.instances) {
    const CellRecord* cell = run.find(proof_of_s.on(instance.id));
    const bool is_proven = cell != nullptr && cell->is_right();
    regular.cells.push_back(is_proven ? TableCell{"proven", {}} : time_entry(table, cell));
  }
  table.rows.push_back(std::move(regular));
  for (const Hypothesis& hypothesis : hypotheses) {
    TableRow row{hypothesis.label, {}, {}};
    for (const InstanceSummary& instance : run.instances) {
      const auto failures = particular(run.find(as_published({}).on(instance.id)), hypothesis.failures);
      row.cells.push_back(!failures        ? empty_entry()
                          : *failures == 0 ? TableCell{"holds", {}}
                                           : TableCell{fmt::format("fails ({:.0f})", *failures), {}});
    }
    table.rows.push_back(std::move(row));
  }
  table.remarks = {
      "(h1): proven along all of S by full-space, mode=certified. (h2) to (h7): at the plan that rcp begins "
      "with, to rounding, where t leaves the part of the support that holds [0, 1]; in brackets, how often a "
      "hypothesis fails. Where (h4) to (h6) fail S may still keep away from that t; where (h7) fails "
      "Algorithm 2 comes first."};
  return table;
}

constexpr const char* path_remark =
    "on S: solutions met before the end, up to reflection; iterations: accepted steps; δ: in (A+, t), in the "
    "file's unit.";

/// α from far below the published 0.1 to nearly the 1/2 of Proposition 2, and no change at all.
std::vector<Reading> exchanges() {
  std::vector<Reading> all;
  for (const char* alpha : {"0.02", "0.05", "0.1", "0.2", "0.3", "0.45"})
    all.push_back(
        {fmt::format("α = {}", alpha),
         as_published(alpha == std::string_view("0.1") ? OptionMap{} : OptionMap{{"alpha", alpha}})});
  all.push_back({"swap=off", as_published({{"swap", "off"}})});
  return all;
}

}  // namespace

std::vector<Variant> printed_variants() {
  std::vector<Variant> variants = variants_of(readings());
  variants.insert(variants.begin(), proof_of_s);
  return variants;
}

std::vector<Table> build_printed(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "printed";
  table.caption = "What the printed text of Algorithms 1 to 4 needs: rcp, mode=paper";
  table.stub = "to the letter";
  table.groups = {{"", path_columns}, {"Algorithm 2", {"exchanges", "restorations", "shifts", "in vain"}}};
  add_readings(table, run, readings(), [](const CellRecord* cell, TableRow& row) {
    for (const char* count : {"exchanges", "restorations", "shifts", "shifts_in_vain"})
      row.cells.push_back(so_far(particular(cell, count)));
  });
  table.remarks = {
      "to the letter: which of rcp's options measure (γ alone), shift (for interCS, to the larger radius), "
      "direction (of a shift, where it is undefined or flat), restoring (which parameter leaves) and "
      "turning (by the derivative) follow the printed text; the others are mended.",
      "in vain: shifts that leave γ at α or below, against Proposition 2.", path_remark,
      "The text: " + paper.citation + "."};
  return {table, hypotheses_table(run)};
}

std::vector<Variant> swap_variants() { return variants_of(exchanges()); }

std::vector<Table> build_swap(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "swap";
  table.caption = "Changing the plan near boundary configurations, over α, and not: rcp, mode=paper";
  table.groups = {{"", path_columns}};
  table.groups[0].columns.emplace_back("plan changes");
  add_readings(table, run, exchanges(), [](const CellRecord* cell, TableRow& row) {
    row.cells.push_back(so_far(work_count(cell, &WorkCounters::plan_changes)));
  });
  table.remarks = {
      "swap=off: the first plan is kept; a correction that fails within α = 0.1 of a boundary configuration "
      "is tried on the branch beyond it (section 3.4). Where it gives up, changing the plan is needed; the "
      "smallest δ says how near to a boundary it came.",
      path_remark, "Algorithms: " + paper.citation + "."};
  return {table};
}

}  // namespace gcs
