#pragma once
/// What is asked for of tables, and the cells that this takes.

#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/instance_judge.hpp"
#include "harness/runs/cell_timing.hpp"
#include "harness/tables/tables.hpp"

namespace gcs {

/// What is asked for. Empty lists: the defaults.
struct TableRequest {
  std::vector<std::string> tables;      ///< names of table_kinds()
  std::vector<std::string> instances;   ///< as load_instance takes them; default: the tables' own
  std::vector<std::string> strategies;  ///< default: all that the tables show
  std::optional<int> repetitions;
  TimingLimits limits;
  bool full = false;                         ///< without limits of time
  std::optional<std::filesystem::path> out;  ///< folder in which run.json is kept up to date
  bool logs_progress = false;                ///< in lines, where standard error is no terminal
  bool resume = false;                       ///< go on with the run that is there, if any
  std::vector<std::string> arguments;        ///< the words of the command line, for the record
};

/// Instances made ready. Deques, because tasks point to the scenes and judges point to both.
struct LoadedInstances {
  std::deque<Instance> instances;
  std::deque<Scene> scenes;
  std::deque<InstanceJudge> judges;  ///< empty: accuracy is not asked for

  /// Precondition: an instance of that id is loaded.
  std::size_t number(const std::string& id) const {
    const auto found = std::find_if(instances.begin(), instances.end(),
                                    [&](const Instance& instance) { return instance.id == id; });
    return static_cast<std::size_t>(found - instances.begin());
  }
  const Scene& scene(const std::string& id) const { return scenes[number(id)]; }
};

/// The table of that name. Throws UsageError where there is none.
const TableKind& table_named(const std::string& name);

/// With judges where a table holds answers against references. Throws InputError, and UsageError for instances that are
/// given twice or that no table knows.
LoadedInstances load_all(const TableRequest& request);

/// What a table shows: its own instances, or those that were asked for.
std::vector<std::string> ids_for(const TableKind& kind, const TableRequest& request,
                                 const LoadedInstances& loaded);

/// The external programs that were asked for, which no table names. Their entries refer to the request.
std::deque<StrategyEntry> programs_of(const TableRequest& request);

/// In the order of the tables; those that this version cannot measure are left out. What is measured on one
/// instance stands together, so that a run that is stopped has needed few references.
std::vector<CellTask> tasks_of(const TableRequest& request, LoadedInstances& loaded,
                               const std::deque<StrategyEntry>& programs);

TimingSettings settings_of(const TableRequest& request);

}  // namespace gcs
