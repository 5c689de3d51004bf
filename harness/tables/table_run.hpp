#pragma once
/// Measures what tables need.

#include <functional>
#include <memory>
#include <string>

#include "harness/runs/run_file.hpp"
#include "harness/tables/table_tasks.hpp"
#include "solvers/running/crew.hpp"

namespace gcs {

/// Measures on one thread. Throws InputError for an instance that cannot be read, or a run that cannot be
/// resumed (see RunFolder); UsageError for names that are unknown or given twice; OutputError.
///
/// Where there is a crew and the tables hold answers against references, it shares what is solved for the answers, all
/// cells of an instance at a time, which takes their reference and what decides whether a variant is too slow; times are
/// measured by this process alone, and after that. The answers are those of one process.
RunFile run_tables(const TableRequest& request, const Publications& publications, Monitor& progress,
                   Crew* crew = nullptr);

/// What another process of the crew does of each item, where `task` is one of run_tables; otherwise null.
std::unique_ptr<ItemWork> begin_cells(const std::string& task);

}  // namespace gcs
