#pragma once
/// Measures what tables need.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "harness/runs/cell_timing.hpp"
#include "harness/runs/run_file.hpp"
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

/// Measures on one thread. Throws InputError for an instance that cannot be read, or a run that cannot be
/// resumed (see RunFolder); UsageError for names that are unknown or given twice; OutputError.
RunFile run_tables(const TableRequest& request, const Publications& publications, Monitor& progress);

}  // namespace gcs
