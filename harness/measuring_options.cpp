#include "harness/measuring_options.hpp"

#include <CLI/CLI.hpp>
#include <string>

namespace gcs {

void add_measuring_options(CLI::App& command, const char* files, TableRequest& request) {
  command.add_option("--strategies", request.strategies, "Only these strategies, separated by commas")
      ->delimiter(',');
  command
      .add_option("--repetitions", request.repetitions,
                  "Runs of every cell; default: as time allows, at least 3")
      ->check(CLI::Range(1, 1000000))
      ->type_name("N");
  command.add_option("--out", request.out, std::string("Folder for run.json, the tables and ") + files)
      ->type_name("DIR");
  command.add_flag("--full", request.full, "No limits of time (otherwise 10 s a solve, 14 minutes in all)");
  command.add_flag("--resume", request.resume, "Keep the finished cells of the run in --out");
}

}  // namespace gcs
