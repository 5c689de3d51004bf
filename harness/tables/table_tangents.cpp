/// Lines at given distances from four points (4p1L): published counts beside ours.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

const Variant solver{"sphere-tangents", {}};

/// What a number of the answer is called, and where the literature prints it.
struct Quantity {
  const char* label;
  const char* row;
  std::optional<double> (*of)(const CellRecord& cell);
};

std::optional<double> number(const std::optional<Natural>& count) {
  return count ? std::optional(count->approximate()) : std::nullopt;
}

template <int which>
std::optional<double> particular(const CellRecord& cell) {
  constexpr std::array names{"bezout_paths", "paths_to_infinity", "oriented_solutions"};
  const auto count = cell.particular(names[which]);
  return count ? std::optional(static_cast<double>(*count)) : std::nullopt;
}

std::optional<double> complex_lines(const CellRecord& cell) {
  return number(cell.counts.complex_up_to_reflection);
}

std::optional<double> real_lines(const CellRecord& cell) { return number(cell.counts.real_up_to_reflection); }

std::optional<double> multiplicity(const CellRecord& cell) {
  if (cell.solutions.empty()) return std::nullopt;
  int largest = 0;
  for (const RecordedSolution& solution : cell.solutions) largest = std::max(largest, solution.multiplicity);
  return largest;
}

constexpr std::array quantities{
    Quantity{"paths (total degree)", "paths", particular<0>},
    Quantity{"paths to infinity", "paths to infinity", particular<1>},
    Quantity{"oriented solutions", "oriented solutions", particular<2>},
    Quantity{"complex lines", "complex", complex_lines},
    Quantity{"real lines", "real", real_lines},
    Quantity{"largest multiplicity", "multiplicity", multiplicity},
};

/// What is printed of the instance, or of all problems 4p1L.
const PrintedFigure* printed(const Publication& paper, const std::string& row, const std::string& instance) {
  const PrintedFigure* figure = paper.find("PHCpack", row, instance, "");
  return figure != nullptr ? figure : paper.find("section 4.1", row, "4p1L", "");
}

}  // namespace

const std::vector<std::string>& tangents_instances() {
  static const std::vector<std::string> ids{"tangents-durand", "tangents-12-real", "tangents-equal-radii",
                                            "tangents-fourfold"};
  return ids;
}

std::vector<Variant> tangents_variants() { return {solver}; }

std::vector<Table> build_tangents(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "tangents";
  table.caption = "4p1L: lines at given distances from four points, published and ours";
  for (const InstanceSummary& instance : run.instances)
    table.groups.push_back({instance.id, {"published", "ours"}});
  for (const Quantity& quantity : quantities) {
    TableRow row{quantity.label, {}, {}};
    for (const InstanceSummary& instance : run.instances) {
      const CellRecord* cell = run.find(solver.on(instance.id));
      row.cells.push_back(printed_entry(table, printed(paper, quantity.row, instance.id)));
      row.cells.push_back(answer_entry(table, cell, cell == nullptr ? std::nullopt : quantity.of(*cell)));
    }
    table.rows.push_back(std::move(row));
  }
  TableRow times{"time", {}, {}};
  for (const InstanceSummary& instance : run.instances) {
    times.cells.push_back(printed_entry(table, printed(paper, "time_s", instance.id)));
    times.cells.push_back(time_entry(table, run.find(solver.on(instance.id))));
  }
  table.rows.push_back(std::move(times));
  table.remarks = {
      "Ours: sphere-tangents. Lines are counted without direction and once each, whatever their "
      "multiplicity; an oriented solution is a line with a direction.",
      "Published: " + paper.citation +
          ", section 4.1; counts of lines: the demonstrations of PHCpack, and "
          "what the footnotes name.",
      fmt::format("Times: median of interleaved repetitions; {}. Ours: {}.", spread_remark,
                  run.environment.cpu)};
  return {table};
}

}  // namespace gcs
