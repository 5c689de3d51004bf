/// The scan over a grid of Hoffmann and Yuan, section 5, on every scene with a construction plan: what grid and
/// band find of what is known to be there.

#include <fmt/format.h>

#include <array>

#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// An instance, by what it is scanned, and who counts its real solutions.
struct Scanned {
  const char* id;
  const char* strategy;
  const char* step_option;
  std::vector<const char*> steps;  ///< in degrees; each more angle multiplies the grid
  const char* counted_by;

  Variant count() const { return {counted_by, {}, {id}}; }
  Variant scan(const char* step, const char* delta) const {
    return {strategy, {{"method", "published"}, {step_option, step}, {"delta", delta}}, {id}};
  }
};

constexpr std::array bands{"0.05", "0.5"};

const std::vector<Scanned>& all_scanned() {
  static const std::vector<const char*> of_one{"5", "1", "0.2"}, of_two{"10", "5", "1"},
      of_three{"10", "5", "2"};
  static const std::vector<Scanned> all{
      {"hoffmann-yuan", "theta-scan", "dtheta", of_one, "theta-scan"},
      {"k33", "plan-scan", "step", of_one, "plan-scan"},
      {"octahedron", "plan-scan", "step", of_one, "plan-scan"},
      {"disulfide", "plan-scan", "step", of_one, "plan-scan"},
      {"dodecagon", "plan-scan", "step", of_two, "plan-scan"},
      {"icosahedron", "plan-scan", "step", of_three, "monodromy"},
  };
  return all;
}

/// Real solutions up to reflection, of a strategy that finds all.
std::optional<double> known_solutions(const CellRecord* cell) {
  if (cell == nullptr || !cell->is_right() || !cell->counts.real_up_to_reflection) return std::nullopt;
  return cell->counts.real_up_to_reflection->approximate();
}

/// How many of the scans miss some of the solutions.
struct Tally {
  int scans = 0;
  int incomplete = 0;
};

std::string heading_of(const RunFile& run, const Scanned& scanned) {
  const CellRecord* any = run.find(scanned.scan(scanned.steps.front(), bands.front()).on(scanned.id));
  const auto angles = particular(any, "driving_parameters");
  const auto known = known_solutions(run.find(scanned.count().on(scanned.id)));
  return fmt::format("{}: {}, {}", scanned.id, angles ? "k = " + number_text(*angles) : "k not measured",
                     known ? fmt::format("{} real solutions by {}", number_text(*known), scanned.counted_by)
                           : fmt::format("real solutions not counted by {}", scanned.counted_by));
}

TableRow row_of(Table& table, const RunFile& run, const Scanned& scanned, const char* step, const char* band,
                Tally& tally) {
  const CellRecord* cell = run.find(scanned.scan(step, band).on(scanned.id));
  const auto known = known_solutions(run.find(scanned.count().on(scanned.id)));
  const auto found = proven_real(cell);
  const auto missed = known && found ? std::optional(*known - *found) : std::nullopt;
  if (missed) ++tally.scans;
  if (missed && *missed > 0) ++tally.incomplete;
  const auto points =
      cell == nullptr ? std::nullopt : std::optional(static_cast<double>(cell->work.evaluations));
  TableRow row{fmt::format("{}°, δ = {}", step, band), {}, {}};
  row.cells = {answer_entry(table, cell, points),
               answer_entry(table, cell, particular(cell, "coarse_solutions")),
               answer_entry(table, cell, particular(cell, "refined_solutions")),
               answer_entry(table, cell, found),
               answer_entry(table, cell, missed),
               time_entry(table, cell)};
  return row;
}

}  // namespace

const std::vector<std::string>& scan_instances() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> all;
    for (const Scanned& scanned : all_scanned()) all.emplace_back(scanned.id);
    return all;
  }();
  return ids;
}

std::vector<Variant> scan_variants() {
  std::vector<Variant> variants;
  for (const Scanned& scanned : all_scanned()) {
    variants.push_back(scanned.count());
    for (const char* step : scanned.steps)
      for (const char* band : bands) variants.push_back(scanned.scan(step, band));
  }
  return variants;
}

std::vector<Table> build_scan(const RunFile& run, const Publication& paper) {
  Table table;
  table.name = "scan";
  table.caption = "Hoffmann, Yuan, section 5: scans over a grid of all k driving parameters";
  table.stub = "step, band";
  table.groups = {{"", {"grid points", "coarse", "refined", "found", "missed", "time"}}};
  Tally tally;
  for (const InstanceSummary& instance : run.instances)
    for (const Scanned& scanned : all_scanned()) {
      if (instance.id != scanned.id) continue;
      table.rows.push_back({heading_of(run, scanned), {}, {}});
      for (const char* step : scanned.steps)
        for (const char* band : bands) table.rows.push_back(row_of(table, run, scanned, step, band, tally));
    }
  table.remarks = {
      fmt::format(
          "{} of {} scans miss solutions that are there: what a grid finds depends on its step and on "
          "the band, and nothing says from inside that it has found all.",
          tally.incomplete, tally.scans),
      "refined: distinct ends of Newton's method, for 5p1L counted in the 'fixed frame', mirror images "
      "apart. "
      "found: those of them that are proven, up to reflection; missed: of those that the heading counts, "
      "which "
      "plan-scan and theta-scan prove by subdivision to be all, and monodromy finds. δ in the unit of the "
      "instance, for the largest distance that the plan leaves out.",
      fmt::format(
          "Times: preparing and solving once on one thread, median of interleaved repetitions; {}. {}.",
          spread_remark, run.environment.cpu),
      "The method: " + paper.citation + ", section 5, which prints no figures."};
  return {table};
}

}  // namespace gcs
