#include "harness/measuring.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <string>

#include "harness/progress_line.hpp"
#include "harness/stop_conditions.hpp"
#include "harness/table_output.hpp"

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

RunRecord measure_and_show(const TableRequest& request, bool quiet) {
  catch_interrupts();
  RunRecord run = [&] {
    ProgressLine progress(!quiet);
    return run_tables(request, {}, progress);
  }();
  const TableSet set = build_tables(run, {});
  if (request.out) write_tables(set, *request.out, table_formats());
  std::cout << shown_on_terminal(set);
  return run;
}

}  // namespace gcs
