#pragma once
/// What `gcsbench precision` and `gcsbench stability` take alike.

#include "harness/table_run.hpp"

namespace CLI {
class App;
}

namespace gcs {

/// Adds --strategies, --repetitions, --out, --full and --resume, which write into `request`; `files` says
/// what the folder holds beside run.json.
void add_measuring_options(CLI::App& command, const char* files, TableRequest& request);

}  // namespace gcs
