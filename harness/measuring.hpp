#pragma once
/// What `gcsbench precision` and `gcsbench stability` take and do alike.

#include "harness/table_run.hpp"

namespace CLI {
class App;
}

namespace gcs {

/// Adds --strategies, --repetitions, --out, --full and --resume, which write into `request`; `files` says
/// what the folder holds beside run.json.
void add_measuring_options(CLI::App& command, const char* files, TableRequest& request);

/// Measures, writes the folder that the request names, if any, and prints the tables. Throws as run_tables
/// does.
RunRecord measure_and_show(const TableRequest& request, bool quiet);

}  // namespace gcs
