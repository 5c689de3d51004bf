#include "harness/tables/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "harness/instances/families.hpp"
#include "harness/instances/instance_lookup.hpp"

namespace gcs {
namespace {

constexpr std::string_view imbach = "imbach-mathis-schreck-2016";
constexpr std::string_view hoffmann = "hoffmann-yuan-2000";
constexpr std::string_view general_scenes = "general-scenes";
constexpr std::string_view realisations = "realisations";

constexpr bool free_columns = true;
constexpr bool shows_solutions = true;
constexpr bool measures_accuracy = true;
constexpr bool shows_times = true;
constexpr bool knows_general = true;
constexpr std::vector<Drawing> (*no_drawing)(const RunFile&) = nullptr;

/// The run as far as one table speaks of it.
RunFile part_of(const RunFile& run, const RequestedTable& table) {
  RunFile part = run;
  std::erase_if(part.instances, [&](const InstanceSummary& instance) {
    return std::find(table.instances.begin(), table.instances.end(), instance.id) == table.instances.end();
  });
  return part;
}

/// An empty one for a table of our own.
const Publication& publication_of(const TableKind& kind, const Publications& publications) {
  static const Publication none;
  return kind.source.empty() ? none : publications.find(kind.source)->second;
}

/// The shipped instances that measurements know.
std::vector<std::string> measured_instances() {
  std::vector<std::string> ids = shipped_instances();
  std::erase_if(ids, [](const std::string& id) { return load_instance(id).problem.is_general(); });
  return ids;
}

const std::vector<std::string>& precision_instances() {
  static const std::vector<std::string> ids = measured_instances();
  return ids;
}

const std::vector<std::string>& all_family_members() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> members;
    for (const InstanceFamily& family : families())
      for (std::string& id : family.members()) members.push_back(std::move(id));
    return members;
  }();
  return ids;
}

std::vector<Variant> all_defaults() {
  std::vector<Variant> variants;
  for (const StrategyEntry& entry : all_strategies()) variants.push_back({std::string(entry.name), {}});
  return variants;
}

std::vector<Variant> all_precision_variants() { return precision_variants(all_strategies()); }

void append(TableSet& set, const TableKind& kind, const RunFile& part, const Publication& paper) {
  for (Table& table : kind.build(part, paper)) set.tables.push_back(std::move(table));
  if (kind.draw == nullptr) return;
  for (Drawing& drawing : kind.draw(part)) set.drawings.push_back(std::move(drawing));
}

/// What they print of the instances that the run has measured, of which other contents may have been given
/// the same ids.
Publications publications_on(const RunFile& run, Publications publications) {
  const auto is_of_another = [&](const auto& printed) {
    return std::ranges::any_of(run.instances, [&](const InstanceSummary& instance) {
      return instance.id == printed.instance && !instance.is_shipped;
    });
  };
  for (auto& [name, publication] : publications) {
    std::erase_if(publication.figures, is_of_another);
    std::erase_if(publication.solutions, is_of_another);
  }
  return publications;
}

/// Why nothing published stands beside an instance of which papers print something.
void note_altered(const RunFile& run, const Publications& publications, std::vector<std::string>& lines) {
  for (const InstanceSummary& instance : run.instances) {
    const bool is_printed = std::ranges::any_of(publications, [&](const auto& entry) {
      return std::ranges::any_of(entry.second.figures,
                                 [&](const PrintedFigure& figure) { return figure.instance == instance.id; });
    });
    if (is_printed && !instance.is_shipped)
      lines.push_back(
          fmt::format("{}: not the shipped instance; nothing published is shown beside it", instance.id));
  }
}

}  // namespace

bool Variant::is_for(const std::string& instance) const {
  const auto is_in = [&](const std::vector<std::string>& ids) {
    return std::find(ids.begin(), ids.end(), instance) != ids.end();
  };
  return (only_on.empty() || is_in(only_on)) && !is_in(not_on);
}

std::span<const TableKind> table_kinds() {
  static const std::array kinds{
      TableKind{"table1", "numbers of solutions and running times (Imbach et al., Table 1)", imbach,
                paper_instances, free_columns, !shows_solutions, table1_variants, build_table1},
      TableKind{"table2", "details of tracking S (Imbach et al., Table 2), and ratios of times", imbach,
                paper_instances, free_columns, !shows_solutions, table2_variants, build_table2},
      TableKind{"printed", "what the printed text of Algorithms 1 to 4 needs (Imbach et al.)", imbach,
                sketched_instances, free_columns, !shows_solutions, printed_variants, build_printed,
                no_drawing, !measures_accuracy, load_instance, !shows_times},
      TableKind{"swap", "changing the plan near boundaries, over alpha (Imbach et al., section 4)", imbach,
                sketched_instances, free_columns, !shows_solutions, swap_variants, build_swap, no_drawing,
                !measures_accuracy, load_instance, !shows_times},
      TableKind{"plan-changes",
                "plan changes where S turns exponentially often (Imbach et al., section 7.3.3)", imbach,
                plan_changes_instances, !free_columns, !shows_solutions, plan_changes_variants,
                build_plan_changes, draw_plan_changes, !measures_accuracy, load_instance, !shows_times},
      TableKind{"hoffmann-yuan", "five points and a line (Hoffmann, Yuan, Tables 1 and 2, Fig. 7)", hoffmann,
                pyramid_instances, !free_columns, shows_solutions, pyramid_variants, build_pyramid,
                draw_pyramid},
      TableKind{"tangents", "lines at given distances from four points (Hoffmann, Yuan)", hoffmann,
                tangents_instances, !free_columns, shows_solutions, tangents_variants, build_tangents},
      TableKind{"three-ways", "systems of equations for 6p, 4p1L and 5p1L, and their paths (Hoffmann, Yuan)",
                hoffmann, three_ways_instances, !free_columns, !shows_solutions, three_ways_variants,
                build_three_ways},
      TableKind{"scan", "scans over grids of driving parameters (Hoffmann, Yuan, section 5)", hoffmann,
                scan_instances, !free_columns, !shows_solutions, scan_variants, build_scan},
      TableKind{"subdivision",
                "branch and prune over boxes, and what spares boxes (Hoffmann, Yuan, section 4.4)", hoffmann,
                subdivision_instances, free_columns, !shows_solutions, subdivision_variants,
                build_subdivision},
      TableKind{"ablation", "one option of a strategy changed at a time, and what is left out", imbach,
                ablation_instances, free_columns, !shows_solutions, ablation_variants, build_ablation},
      TableKind{"general", "scenes of lines, planes, bodies and angles: what is known, found and proven",
                general_scenes, general_instances, free_columns, !shows_solutions, general_variants,
                build_general, no_drawing, !measures_accuracy, load_instance, shows_times, knows_general},
      TableKind{"realisations",
                "exact counts of realisations of minimally rigid graphs, and what is found of them",
                realisations, realisations_instances, !free_columns, !shows_solutions, realisations_variants,
                build_realisations, no_drawing, !measures_accuracy, load_instance, !shows_times},
      TableKind{"records", "minimally rigid graphs at lengths with many real realisations", realisations,
                records_instances, free_columns, !shows_solutions, realisations_variants, build_records,
                no_drawing, !measures_accuracy, load_instance, !shows_times},
  };
  return kinds;
}

const TableKind& precision_kind() {
  static const TableKind kind{"precision",
                              "error against run time",
                              "",
                              precision_instances,
                              free_columns,
                              !shows_solutions,
                              all_precision_variants,
                              build_precision,
                              draw_precision,
                              measures_accuracy,
                              load_instance,
                              shows_times,
                              knows_general};
  return kind;
}

const TableKind& stability_kind() {
  static const TableKind kind{"stability",
                              "stiff and extreme families",
                              "",
                              all_family_members,
                              free_columns,
                              !shows_solutions,
                              all_defaults,
                              build_stability,
                              draw_stability,
                              measures_accuracy,
                              load_member,
                              shows_times,
                              knows_general};
  return kind;
}

const TableKind* find_table(std::string_view name) {
  for (const TableKind* kind : {&precision_kind(), &stability_kind()})
    if (name == kind->name) return kind;
  const auto kinds = table_kinds();
  const auto found =
      std::find_if(kinds.begin(), kinds.end(), [&](const TableKind& kind) { return kind.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

std::optional<std::string> why_unavailable(const TableKind& kind) {
  const std::vector<Variant> variants = kind.variants();
  const auto strategies = all_strategies();
  const auto is_there = [&](const Variant& variant) {
    return std::any_of(strategies.begin(), strategies.end(),
                       [&](const StrategyEntry& entry) { return entry.name == variant.strategy; });
  };
  const auto missing = std::find_if_not(variants.begin(), variants.end(), is_there);
  if (missing == variants.end()) return std::nullopt;
  return fmt::format("this version has no strategy '{}'", missing->strategy);
}

Publications load_publications() {
  Publications publications;
  for (const TableKind& kind : table_kinds())
    if (publications.count(kind.source) == 0)
      publications[std::string(kind.source)] = load_publication(std::string(kind.source));
  return publications;
}

const std::vector<std::string>& sketched_instances() {
  static const std::vector<std::string> ids = [] {
    std::vector<std::string> all = measured_instances();
    std::erase_if(all, [](const std::string& id) {
      const ProblemStatement problem = load_instance(id).problem;
      return !problem.sketch || !problem.lines.empty();
    });
    return all;
  }();
  return ids;
}

const std::vector<std::string>& paper_instances() {
  static const std::vector<std::string> ids{"octahedron", "disulfide", "dodecagon", "icosahedron"};
  return ids;
}

std::string measured_with(const RunFile& run) {
  const Environment& with = run.environment;
  return fmt::format("Ours: measured {}, commit {}, {}, {}, strategies on {} {}.", run.started, with.commit,
                     with.cpu, with.compiler, with.threads, with.threads == 1 ? "thread" : "threads");
}

TableSet build_tables(const RunFile& run, const Publications& all) {
  const Publications publications = publications_on(run, all);
  TableSet set;
  for (const RequestedTable& table : run.tables) {
    const TableKind* kind = find_table(table.name);
    if (kind == nullptr) {
      set.lines.push_back(fmt::format("{}: this version knows no such table", table.name));
    } else if (const auto reason = why_unavailable(*kind)) {
      set.lines.push_back(fmt::format("{}: not measured, {}", table.name, *reason));
    } else if (table.instances.empty()) {
      set.lines.push_back(fmt::format("{}: not measured, none of its instances was asked for", table.name));
    } else {
      append(set, *kind, part_of(run, table), publication_of(*kind, publications));
    }
  }
  note_altered(run, all, set.lines);
  set.measurements = build_measurements(run);
  for (Table& table : set.tables) table.remarks.push_back(measured_with(run));
  return set;
}

}  // namespace gcs
