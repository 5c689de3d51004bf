/// Scenes of lines, planes, bodies and angles: the numbers of solutions that are known, what each strategy that takes a
/// scene finds of them, and what of it is proven.

#include <fmt/format.h>

#include "harness/results/exec_strategy.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// What is known is a number, or the most that there can be.
TableCell known_entry(Table& table, const Publication& known, const std::string& row,
                      const std::string& instance) {
  const PrintedFigure* figure = known.find("known", row, instance, "");
  return printed_entry(table,
                       figure != nullptr ? figure : known.find("known", row + ", at most", instance, ""));
}

TableRow known_row(Table& table, const Publication& known, const std::string& instance) {
  TableRow row{"known", {}, {}};
  for (const char* quantity : {"complex", "real"})
    row.cells.push_back(known_entry(table, known, quantity, instance));
  row.cells.resize(static_cast<std::size_t>(table.column_count()), empty_entry());
  return row;
}

/// Those on S, of a strategy that follows it.
std::optional<double> real_found(const CellRecord& cell) {
  if (cell.counts.on_path) return static_cast<double>(*cell.counts.on_path);
  return number(cell.counts.real_up_to_reflection);
}

TableCell certified_entry(const CellRecord& cell, std::uint64_t RecordedProofs::*count) {
  return cell.proofs && cell.is_right()
             ? TableCell{number_text(static_cast<double>((*cell.proofs).*count)), {}}
             : empty_entry();
}

/// Which solutions they are, and what proves that they are all.
TableCell standing_entry(Table& table, const InstanceSummary& instance, const CellRecord& cell) {
  if (!cell.is_right() || !cell.claim) return empty_entry();
  if (cell.proofs && cell.proofs->is_complete && instance.limit)
    return {"all, proven", {table.footnote("No values have more: " + limit_origin(*instance.limit))}};
  switch (*cell.claim) {
    case Claim::all_complex:
    case Claim::all_real:
      return {"all, found", {}};
    case Claim::on_path:
    case Claim::on_path_of_core:
      return {"those on S", {}};
    case Claim::all_real_of_component:
      return {"all of a component", {}};
    case Claim::some_real:
      break;
  }
  return {"some real ones", {}};
}

TableRow found_row(Table& table, const InstanceSummary& instance, const CellRecord& cell) {
  TableRow row{label_of(cell.spec), {}, {}};
  row.cells.push_back(answer_entry(table, &cell, number(cell.counts.complex_up_to_reflection)));
  row.cells.push_back(answer_entry(table, &cell, real_found(cell)));
  row.cells.push_back(certified_entry(cell, &RecordedProofs::classes));
  row.cells.push_back(certified_entry(cell, &RecordedProofs::real));
  row.cells.push_back(standing_entry(table, instance, cell));
  row.cells.push_back(time_entry(table, &cell));
  return row;
}

}  // namespace

const std::vector<std::string>& general_instances() {
  static const std::vector<std::string> ids{"planar-platform",
                                            "platform",
                                            "dietmaier",
                                            "octahedral-5p1h",
                                            "octahedral-4p2h",
                                            "octahedral-3p3h",
                                            "octahedron-line",
                                            "two-lines",
                                            "three-points-three-lines-angles",
                                            "three-points-three-lines-distances"};
  return ids;
}

std::vector<Variant> general_variants() {
  return {{"monodromy", {}},
          {"polyhedral", {}},
          {"system-paths", {{"system", "quadrics"}}},
          {"system-paths", {{"system", "echelon"}}},
          {"cayley-menger", {}},
          {"plan-scan", {}},
          {"newton-multistart", {}},
          {"explore", {}},
          {"full-space", {}},
          {"full-space", {{"mode", "certified"}}},
          {"rcp", {}}};
}

std::vector<Table> build_general(const RunFile& run, const Publication& known) {
  Table table;
  table.name = "general";
  table.caption = "Scenes of lines, planes, bodies and angles: solutions known, found and proven";
  table.groups = {
      {"solutions", {"complex", "real"}}, {"certified", {"all", "real"}}, {"", {"which", "time"}}};
  for (const InstanceSummary& instance : run.instances) {
    table.rows.push_back({fmt::format("{}, {}", instance.id, instance.convention), {}, {}});
    table.rows.push_back(known_row(table, known, instance.id));
    for (const Variant& variant : general_variants()) {
      const CellRecord* cell = run.find(variant.on(instance.id));
      if (cell != nullptr && cell->status != RunStatus::unsupported)
        table.rows.push_back(found_row(table, instance, *cell));
    }
    for (const CellRecord& cell : run.cells)
      if (cell.spec.instance == instance.id && exec_command(cell.spec.strategy))
        table.rows.push_back(found_row(table, instance, cell));
  }
  table.remarks = {
      "Beside each scene stands which figures are one solution. A strategy that is not listed there cannot "
      "do "
      "the scene.",
      "certified: so many certificates prove to exist, each in a class of its own, and so many of them to be "
      "real. all, proven: a bound is met. all, found: the strategy claims all solutions, and that there are "
      "no "
      "more is not proven.",
      fmt::format("Times: preparing and solving on one thread, without proofs, median of interleaved "
                  "repetitions; {}. Ours: {}.",
                  spread_remark, run.environment.cpu)};
  return {table};
}

}  // namespace gcs
