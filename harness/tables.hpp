#pragma once
/// The tables of `gcsbench tables`: what each needs measured, and how it is built from a run.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "harness/published.hpp"
#include "harness/run_record.hpp"
#include "harness/table.hpp"

namespace gcs {

/// What a table measures on one instance: a strategy with options.
struct Variant {
  std::string strategy;
  OptionMap given;

  CellSpec on(const std::string& instance) const { return {instance, strategy, given}; }
  bool operator==(const Variant&) const = default;
};

/// A table that can be asked for by name. `unavailable` says why this version cannot measure it; empty: it
/// can.
struct TableKind {
  std::string_view name;
  std::string_view summary;
  std::vector<Variant> (*variants)() = nullptr;
  std::vector<Table> (*build)(const RunRecord& run, const Publication& paper) = nullptr;
  std::string_view unavailable;
};

/// All tables, in the order of `all`.
std::span<const TableKind> table_kinds();

/// The table of that name, or nullptr.
const TableKind* find_table(std::string_view name);

/// The instances of the paper's tables, in its order.
const std::vector<std::string>& paper_instances();

/// What a run shows.
struct TableSet {
  std::vector<Table> tables;
  Table measurements;              ///< all that was measured, whatever the tables show of it
  std::vector<std::string> lines;  ///< tables that were asked for and cannot be had, one line each
};

/// Builds what the run asked for, without solving.
TableSet build_tables(const RunRecord& run, const Publication& paper);

std::vector<Variant> table1_variants();
std::vector<Table> build_table1(const RunRecord& run, const Publication& paper);

std::vector<Variant> table2_variants();
/// Table 2, and the ratios between the strategies that follow from it.
std::vector<Table> build_table2(const RunRecord& run, const Publication& paper);
Table build_ratios(const RunRecord& run, const Publication& paper);

std::vector<Variant> ablation_variants();
std::vector<Table> build_ablation(const RunRecord& run, const Publication& paper);

/// Every cell of the run with its repetitions, whatever the tables show of it.
Table build_measurements(const RunRecord& run);

}  // namespace gcs
