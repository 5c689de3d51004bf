/// Stiff and extreme families: what every strategy makes of them, and how its errors compare with the
/// condition of the solutions.

#include <fmt/format.h>

#include <algorithm>

#include "harness/drawings/heat_map.hpp"
#include "harness/instances/families.hpp"
#include "harness/results/exec_strategy.hpp"
#include "harness/tables/table_entries.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {
namespace {

/// What a strategy made of a member, from the best to the worst.
enum class Outcome { sharp, fair, inexact, some, nothing_to_measure, refused, wrong, not_run };

/// Beyond this quotient an error has another cause than the condition of the solution.
constexpr double far_off = 1000;

bool is_refusal(const CellRecord& cell) {
  return cell.status == RunStatus::partial || cell.status == RunStatus::gave_up;
}

Outcome outcome_of(const CellRecord& cell) {
  if (cell.is_search_in_vain()) return Outcome::nothing_to_measure;
  if (is_refusal(cell)) return Outcome::refused;
  if (cell.status == RunStatus::infinite)
    return is_ill_posed(cell.spec.instance) ? Outcome::nothing_to_measure : Outcome::wrong;
  if (cell.status != RunStatus::complete) return Outcome::not_run;
  if (cell.is_flawed()) return Outcome::wrong;
  if (!cell.accuracy || !cell.accuracy->missed) return Outcome::not_run;
  if (*cell.accuracy->missed > 0) return Outcome::some;
  if (cell.accuracy->met == 0) return Outcome::nothing_to_measure;
  if (cell.accuracy->largest_quotient <= explained_quotient) return Outcome::sharp;
  return cell.accuracy->largest_quotient <= far_off ? Outcome::fair : Outcome::inexact;
}

/// The families that the run has members of.
std::vector<const InstanceFamily*> families_of(const RunFile& run) {
  std::vector<const InstanceFamily*> shown;
  for (const InstanceFamily& family : families()) {
    const std::string first = family.members().front();
    if (std::any_of(run.instances.begin(), run.instances.end(),
                    [&](const InstanceSummary& instance) { return instance.id == first; }))
      shown.push_back(&family);
  }
  return shown;
}

/// Those that can do the tame member, in the order of the run.
std::vector<std::string> strategies_of(const RunFile& run, const InstanceFamily& family) {
  std::vector<std::string> strategies;
  for (const CellRecord& cell : run.cells)
    if (cell.spec.instance == family.members().front() && cell.status != RunStatus::unsupported)
      strategies.push_back(cell.spec.strategy);
  return strategies;
}

std::vector<const CellRecord*> cells_of(const RunFile& run, const InstanceFamily& family,
                                        const std::string& strategy) {
  std::vector<const CellRecord*> cells;
  for (const std::string& id : family.members()) cells.push_back(run.find({id, strategy, {}}));
  return cells;
}

/// "2 missed" and the like, before a number.
std::string flaws(const Accuracy& accuracy) {
  std::string text;
  if (accuracy.missed.value_or(0) > 0) text += fmt::format("{} missed ", *accuracy.missed);
  if (accuracy.spurious > 0) text += fmt::format("{} spurious ", accuracy.spurious);
  return text;
}

TableCell accuracy_entry(Table& table, const CellRecord* cell, double Accuracy::*number) {
  if (cell != nullptr && cell->is_search_in_vain())
    return {"none found",
            {table.footnote(label_of(cell->spec) + ": " + cell->reason +
                            "; there is none, as the solutions that are proven to be all show")}};
  if (cell == nullptr || cell->status != RunStatus::complete) return answer_entry(table, cell, std::nullopt);
  if (!cell->accuracy) return empty_entry();
  TableCell entry{flaws(*cell->accuracy), {}};
  entry.text += cell->accuracy->met == 0 ? "–" : fmt::format("{:.2g}", (*cell->accuracy).*number);
  if (!cell->difference.empty())
    entry.notes.push_back(table.footnote(label_of(cell->spec) + ": " + cell->difference));
  return entry;
}

TableCell relative_time_entry(const CellRecord* cell, const CellRecord* tame) {
  const auto time = total_time(cell), tame_time = total_time(tame);
  return time && tame_time ? TableCell{number_text(time->median / tame_time->median), {}} : empty_entry();
}

Table build_family(const RunFile& run, const InstanceFamily& family) {
  Table table;
  table.name = fmt::format("stability-{}", family.name);
  table.caption = fmt::format("{}: {}", family.name, family.summary);
  table.groups = {{"", family.values}};
  const auto append = [&](std::string heading, auto entry) {
    table.rows.push_back({std::move(heading), {}, {}});
    for (const std::string& strategy : strategies_of(run, family)) {
      const auto cells = cells_of(run, family, strategy);
      TableRow row{short_name(strategy), {}, {}};
      for (const CellRecord* cell : cells) row.cells.push_back(entry(cell, cells.front()));
      table.rows.push_back(std::move(row));
    }
  };
  const auto append_number = [&](std::string heading, double Accuracy::*number) {
    append(std::move(heading), [&table, number](const CellRecord* cell, const CellRecord*) {
      return accuracy_entry(table, cell, number);
    });
  };
  append_number("error / (condition × unit roundoff)", &Accuracy::largest_quotient);
  append_number("largest error / size", &Accuracy::largest_error);
  append_number("largest condition number", &Accuracy::largest_condition);
  append("time / time of the tame member", relative_time_entry);
  table.remarks = {
      "Columns: the parameter; the first is the tame member. –: no proven solution to compare with.",
      "Error: distance of a point from its place in the proven solution; size: of the scene; condition: of "
      "the "
      "distances' scaled Jacobian; unit roundoff: 2^-53. All are pure numbers, the largest over the "
      "solutions "
      "met.",
      "missed: of what the strategy claims to find, of all real ones where it claims some; spurious: listed, "
      "and no proven solution.",
      "infinite: right where the scene moves, wrong elsewhere. none found: right where none exists, which "
      "others prove; "
      "anywhere else a search that finds nothing gave up."};
  return table;
}

Table build_refusals(const RunFile& run) {
  Table table;
  table.name = "stability-refusals";
  table.caption = "Answers by strategy and family: wrong, refused, of all";
  const auto shown = families_of(run);
  std::vector<std::string> strategies;
  for (const InstanceFamily* family : shown)
    for (const std::string& strategy : strategies_of(run, *family))
      if (std::find(strategies.begin(), strategies.end(), strategy) == strategies.end())
        strategies.push_back(strategy);
  table.groups = {{"", {}}};
  for (const std::string& strategy : strategies) table.groups.back().columns.push_back(short_name(strategy));
  for (const InstanceFamily* family : shown) {
    TableRow row{std::string(family->name), {}, {}};
    const auto able = strategies_of(run, *family);
    for (const std::string& strategy : strategies) {
      if (std::find(able.begin(), able.end(), strategy) == able.end()) {
        row.cells.push_back(empty_entry());
        continue;
      }
      int wrong = 0, refused = 0, all = 0;
      for (const CellRecord* cell : cells_of(run, *family, strategy)) {
        if (cell == nullptr) continue;
        ++all;
        wrong += outcome_of(*cell) == Outcome::wrong ? 1 : 0;
        refused += outcome_of(*cell) == Outcome::refused ? 1 : 0;
      }
      row.cells.push_back({fmt::format("{}, {} of {}", wrong, refused, all), {}});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::vector<Table> build_stability(const RunFile& run, const Publication&) {
  std::vector<Table> tables;
  for (const InstanceFamily* family : families_of(run)) tables.push_back(build_family(run, *family));
  tables.push_back(build_refusals(run));
  return tables;
}

std::vector<Drawing> draw_stability(const RunFile& run) {
  HeatMap map;
  map.description =
      "For each family and strategy, from the tame member on the left to the most extreme one: how the error "
      "compares with the condition number times the unit roundoff, refusals and wrong answers";
  map.classes = {{"error up to 10 cond·u", "#0072B2"},
                 {"up to 1000 cond·u", "#56B4E9"},
                 {"more", "#F0E442"},
                 {"some solutions, as said", "#CC79A7"},
                 {"right: none, or infinite", "#009E73"},
                 {"refused, with the reason", "#C0C0C0"},
                 {"wrong", "#D55E00", true},
                 {"not run, or no reference", "#F0F0F0"}};
  for (const InstanceFamily* family : families_of(run)) {
    map.rows.push_back({std::string(family->name), {}, family->values});
    for (const std::string& strategy : strategies_of(run, *family)) {
      HeatMapRow row{short_name(strategy), {}, {}};
      for (const CellRecord* cell : cells_of(run, *family, strategy))
        row.fields.push_back(cell == nullptr ? -1 : static_cast<int>(outcome_of(*cell)));
      map.rows.push_back(std::move(row));
    }
  }
  return {{"stability", to_svg(map), map.description}};
}

}  // namespace gcs
