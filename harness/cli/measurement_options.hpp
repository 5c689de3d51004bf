#pragma once
/// What `gcsbench tables`, `precision` and `stability` take and do alike.

#include "harness/cli/commands.hpp"
#include "harness/tables/table_run.hpp"

namespace gcs {

/// Adds --strategies, --repetitions, --out, --full and --resume, which write into `request`, whose limits are
/// set; `files` says what the folder holds beside run.json.
void add_measuring_options(CLI::App& command, const char* files, TableRequest& request);

/// How --resume goes on, for --help.
extern const char* const resume_help;

/// Measures, writes the folder that the request names, if any, and prints the tables.
/// Throws as run_tables does.
RunFile measure_and_show(TableRequest request, const Publications& publications,
                         const Invocation& invocation);

}  // namespace gcs
