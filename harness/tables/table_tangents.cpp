/// Lines at given distances from four points (4p1L): published counts beside ours.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// A way to solve, and the head of its column.
struct Way {
  const char* head;
  Variant variant;
};

const std::array<Way, 3>& ways() {
  static const std::array<Way, 3> all{{
      {"quadrics", {"sphere-tangents", {{"method", "published"}, {"system", "quadrics"}}}},
      {"cubic", {"sphere-tangents", {{"method", "published"}, {"system", "cubic"}}}},
      {"eigenvalues", {"sphere-tangents", {}}},
  }};
  return all;
}

/// What a number of the answer is called, and where the literature prints it.
struct Quantity {
  const char* label;
  const char* row;
  std::optional<double> (*of)(const CellRecord& cell);
};

std::optional<double> paths(const CellRecord& cell) { return tracked_paths(&cell); }

std::optional<double> paths_to_infinity(const CellRecord& cell) {
  return paths(cell) ? std::optional(static_cast<double>(cell.counts.at_infinity.value_or(0))) : std::nullopt;
}

std::optional<double> finite_ends(const CellRecord& cell) { return finite_path_ends(&cell); }

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
    Quantity{"paths (total degree)", "paths", paths},
    Quantity{"paths to infinity", "paths to infinity", paths_to_infinity},
    Quantity{"finite ends of paths", "oriented solutions", finite_ends},
    Quantity{"complex lines", "complex", complex_lines},
    Quantity{"real lines", "real", real_lines},
    Quantity{"largest multiplicity", "multiplicity", multiplicity},
};

const PrintedFigure* printed_of_all(const Publication& paper, const std::string& row) {
  return paper.find("section 4.1", row, "4p1L", "");
}

/// What is printed of the instance, or else of all problems 4p1L.
const PrintedFigure* printed(const Publication& paper, const std::string& row, const std::string& instance) {
  const PrintedFigure* figure = paper.find("PHCpack", row, instance, "");
  return figure != nullptr ? figure : printed_of_all(paper, row);
}

/// Of a problem whose numbers are not printed, so that no column is its own.
std::string published_time(const Publication& paper) {
  const PrintedFigure* time = printed_of_all(paper, "time_s");
  return time == nullptr
             ? ""
             : fmt::format("Published time, of a problem not printed: {}. {}", time->printed, time->remark);
}

}  // namespace

const std::vector<std::string>& tangents_instances() {
  static const std::vector<std::string> ids{"tangents-durand", "tangents-12-real", "tangents-equal-radii",
                                            "tangents-fourfold"};
  return ids;
}

std::vector<Variant> tangents_variants() {
  std::vector<Variant> variants;
  for (const Way& way : ways()) variants.push_back(way.variant);
  return variants;
}

std::vector<Table> build_tangents(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "tangents";
  table.caption = "4p1L: lines at given distances from four points, published and ours";
  for (const InstanceSummary& instance : run.instances) {
    table.groups.push_back({instance.id, {"published"}});
    for (const Way& way : ways()) table.groups.back().columns.emplace_back(way.head);
  }
  for (const Quantity& quantity : quantities) {
    TableRow row{quantity.label, {}, {}};
    for (const InstanceSummary& instance : run.instances) {
      row.cells.push_back(printed_entry(table, printed(paper, quantity.row, instance.id)));
      for (const Way& way : ways()) {
        const CellRecord* cell = run.find(way.variant.on(instance.id));
        row.cells.push_back(answer_entry(table, cell, cell == nullptr ? std::nullopt : quantity.of(*cell)));
      }
    }
    table.rows.push_back(std::move(row));
  }
  TableRow times{"time", {}, {}};
  for (const InstanceSummary& instance : run.instances) {
    times.cells.push_back(empty_entry());
    for (const Way& way : ways())
      times.cells.push_back(time_entry(table, run.find(way.variant.on(instance.id))));
  }
  table.rows.push_back(std::move(times));
  table.remarks = {
      "Ours: sphere-tangents. quadrics: the paths of equations (1) to (6) of section 4.1; cubic: those of "
      "the "
      "equations of degrees 2, 3 and 4 left in the direction; eigenvalues: without paths. A path to a line "
      "ends at "
      "one of its two directions. Lines are counted without direction and once each, whatever their "
      "multiplicity.",
      "Published: " + paper.citation +
          ", section 4.1; counts of lines: the demonstrations of PHCpack, and "
          "what the footnotes name.",
      published_time(paper),
      fmt::format("Times: median of interleaved repetitions; {}. Ours: {}.", spread_remark,
                  run.environment.cpu)};
  return {table};
}

}  // namespace gcs
