#pragma once
/// The tables of `gcsbench tables`: what each needs measured, and how it is built from a run.

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/drawings/drawing.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/runs/published.hpp"
#include "harness/runs/run_file.hpp"
#include "harness/tables/table.hpp"

namespace gcs {

/// What a table measures on one instance: a strategy with options.
struct Variant {
  std::string strategy;
  OptionMap given;
  std::vector<std::string> only_on = {};  ///< ids of instances; empty: all of the table's but `not_on`
  std::vector<std::string> not_on = {};
  int digits = 0;  ///< to which every solution is refined; 0: doubles

  CellSpec on(const std::string& instance) const { return {instance, strategy, given, digits}; }
  bool is_for(const std::string& instance) const;
};

/// A table that can be asked for by name.
struct TableKind {
  std::string_view name;
  std::string_view summary;
  std::string_view source;  ///< its publication in results/published; empty: none
  const std::vector<std::string>& (*instances)() = nullptr;
  bool has_free_columns = true;  ///< may show other instances than `instances`
  bool shows_solutions = false;  ///< not only how many there are: its cells keep them
  std::vector<Variant> (*variants)() = nullptr;
  std::vector<Table> (*build)(const RunFile& run, const Publication& paper) = nullptr;
  std::vector<Drawing> (*draw)(const RunFile& run) = nullptr;  ///< null: no figure
  bool measures_accuracy = false;  ///< answers are held against references, and not certified
  Instance (*load)(const std::string& argument) = load_instance;
  bool shows_times = true;     ///< otherwise its cells are solved once
  bool knows_general = false;  ///< speaks of scenes of more than points, lines in space and distances too
};

/// All tables of `gcsbench tables`, in the order of `all`.
std::span<const TableKind> table_kinds();

/// What `gcsbench precision` measures.
const TableKind& precision_kind();

/// What `gcsbench stability` measures.
const TableKind& stability_kind();

/// The table of that name, of all kinds, or nullptr.
const TableKind* find_table(std::string_view name);

/// Why this version cannot measure the table: it has none of the strategies that it needs.
std::optional<std::string> why_unavailable(const TableKind& kind);

/// Publications by their short names.
using Publications = std::map<std::string, Publication, std::less<>>;

/// Those that the tables name. Throws InputError.
Publications load_publications();

/// The instances of the tables of Imbach et al., in their order.
const std::vector<std::string>& paper_instances();

/// What a run shows.
struct TableSet {
  std::vector<Table> tables;
  std::vector<Drawing> drawings;
  Table measurements;              ///< all that was measured, whatever the tables show of it
  std::vector<std::string> lines;  ///< tables that were asked for and cannot be had, one line each
};

/// When and with what its figures were measured, in a sentence for the remarks of tables.
std::string measured_with(const RunFile& run);

/// Builds what the run asked for, without solving.
TableSet build_tables(const RunFile& run, const Publications& publications);

std::vector<Variant> table1_variants();
std::vector<Table> build_table1(const RunFile& run, const Publication& paper);

std::vector<Variant> table2_variants();
/// Table 2, the ratios between the strategies that follow from it, and what they are due to.
std::vector<Table> build_table2(const RunFile& run, const Publication& paper);
Table build_ratios(const RunFile& run, const Publication& paper);
/// Steps, evaluations and eliminations without and with a plan.
Table build_costs(const RunFile& run);

/// Shipped instances of points that have a sketch.
const std::vector<std::string>& sketched_instances();
std::vector<Variant> printed_variants();
/// What the printed text of Algorithms 1 to 4 needs, deviation by deviation.
std::vector<Table> build_printed(const RunFile& run, const Publication& paper);
std::vector<Variant> swap_variants();
/// Algorithm 1 with and without changes of the plan, over α.
std::vector<Table> build_swap(const RunFile& run, const Publication& paper);

/// The chains of rockers.
const std::vector<std::string>& plan_changes_instances();
std::vector<Variant> plan_changes_variants();
/// How often the plan is changed where S turns exponentially often.
std::vector<Table> build_plan_changes(const RunFile& run, const Publication& paper);
/// The same over the number of rockers.
std::vector<Drawing> draw_plan_changes(const RunFile& run);

/// Those of the papers, and some of which a part can be left out.
const std::vector<std::string>& ablation_instances();
std::vector<Variant> ablation_variants();
std::vector<Table> build_ablation(const RunFile& run, const Publication& paper);

/// 5p1L and, of 6p, the octahedra.
const std::vector<std::string>& pyramid_instances();
std::vector<Variant> pyramid_variants();
/// The lengths, the solutions, the scans and the octahedra of Hoffmann and Yuan.
std::vector<Table> build_pyramid(const RunFile& run, const Publication& paper);
/// Their 24 solutions beside ours.
Table build_pyramid_solutions(const RunFile& run, const Publication& paper);
/// Their Fig. 7: d34(θ) over all branches, the given d34 and the solutions.
std::vector<Drawing> draw_pyramid(const RunFile& run);

/// Every strategy with its defaults, with each of its accuracy settings, and refined to more digits.
std::vector<Variant> precision_variants(std::span<const StrategyEntry> strategies);
/// One table for each instance: errors, solutions missed and spurious, times and work.
std::vector<Table> build_precision(const RunFile& run, const Publication& paper);
/// Error against time, one plot for each instance, and performance profiles over all.
std::vector<Drawing> draw_precision(const RunFile& run);

/// One table for each family, and how often a strategy refused.
std::vector<Table> build_stability(const RunFile& run, const Publication& paper);
/// A heat map of all families.
std::vector<Drawing> draw_stability(const RunFile& run);

const std::vector<std::string>& tangents_instances();
std::vector<Variant> tangents_variants();
std::vector<Table> build_tangents(const RunFile& run, const Publication& paper);

/// An instance for each problem of Hoffmann and Yuan: 6p, 4p1L, 5p1L.
const std::vector<std::string>& three_ways_instances();
std::vector<Variant> three_ways_variants();
/// Every way to write the problems as equations, and what it costs.
std::vector<Table> build_three_ways(const RunFile& run, const Publication& paper);

/// Those with a construction plan.
const std::vector<std::string>& scan_instances();
std::vector<Variant> scan_variants();
/// Grid by band: what a scan finds, and what it misses.
std::vector<Table> build_scan(const RunFile& run, const Publication& paper);

const std::vector<std::string>& subdivision_instances();
std::vector<Variant> subdivision_variants();
std::vector<Table> build_subdivision(const RunFile& run, const Publication& paper);

/// The shipped scenes of the format gcsbench-instance/2.
const std::vector<std::string>& general_instances();
std::vector<Variant> general_variants();
/// What is known of general scenes, and what each strategy finds and proves.
std::vector<Table> build_general(const RunFile& run, const Publication& paper);

/// Minimally rigid graphs, those with most realisations and all small ones.
const std::vector<std::string>& realisations_instances();
std::vector<Variant> realisations_variants();
/// Exact counts beside what is found and certified.
std::vector<Table> build_realisations(const RunFile& run, const Publication& published);

/// Minimally rigid graphs with lengths of the literature, and the family `record`.
const std::vector<std::string>& records_instances();
/// How many are known, found and certified, and of these how many are real.
std::vector<Table> build_records(const RunFile& run, const Publication& published);

/// Every cell of the run with its repetitions, whatever the tables show of it.
Table build_measurements(const RunFile& run);

}  // namespace gcs
