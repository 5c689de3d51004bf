#include "harness/cli/measurement_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <utility>

#include "harness/base/stop_conditions.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/progress_line.hpp"
#include "harness/report/page.hpp"
#include "harness/tables/table_output.hpp"

namespace gcs {

void add_measuring_options(CLI::App& command, const char* files, TableRequest& request) {
  command
      .add_option("--strategies", request.strategies,
                  "Only these strategies, or external programs exec:COMMAND, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME,...");
  command
      .add_option("--repetitions", request.repetitions,
                  "Runs of every cell; default: as time allows, at least 3")
      ->transform(whole_number(1, 1000000))
      ->type_name("N");
  command
      .add_option("--out", request.out,
                  fmt::format("Folder for run.json, all measurements, {}, and the page, report.html", files))
      ->check(place_name())
      ->type_name("DIR");
  command.add_flag("--full", request.full,
                   fmt::format("No limits of time (otherwise {:.0f} s a solve, {:.0f} minutes in all, "
                               "without making references)",
                               *request.limits.cell_limit_s, *request.limits.total_limit_s / 60));
  command.add_flag("--log", request.logs_progress,
                   "Say on standard error, where that is no terminal, which instance is measured");
  command.add_flag("--resume", request.resume, "Go on with the run in --out, if there is one; see below");
}

const char* const resume_help =
    "\nA run that was stopped in any way goes on with --resume and the same words: what is in the folder is\n"
    "not measured again. More may be asked for than before, never less. A run of another commit, compiler,\n"
    "machine or seed, or of an instance whose content has changed, is refused with what differs.\n";

RunFile measure_and_show(TableRequest request, const Publications& publications,
                         const Invocation& invocation) {
  request.arguments = invocation.arguments;
  catch_interrupts();
  RunFile run = [&] {
    ProgressLine progress(!invocation.quiet, request.logs_progress);
    return run_tables(request, publications, progress, invocation.crew);
  }();
  const TableSet set = build_tables(run, publications);
  if (request.out) {
    write_tables(set, *request.out, table_formats());
    write_drawings(set.drawings, *request.out);
    write_page({load_page_run(*request.out, publications)}, publications, *request.out);
  }
  std::cout << shown_on_terminal(set);
  return run;
}

}  // namespace gcs
