/// gcsbench compare: two runs side by side.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>

#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/comparing/table_compare.hpp"
#include "harness/tables/table_output.hpp"

namespace gcs {

namespace {

struct CompareArguments {
  std::filesystem::path before;
  std::filesystem::path after;
  std::optional<std::filesystem::path> out;
  double margin_percent = 100 * CompareSettings{}.margin;
};

ExitCode compare(const CompareArguments& arguments) {
  CompareSettings settings;
  settings.margin = arguments.margin_percent / 100;
  const RunFile before = load_run_file(arguments.before);
  const RunFile after = load_run_file(arguments.after);
  const Comparison comparison = compare_runs(before, after, settings);
  if (comparison.compared == 0)
    throw InputError(arguments.after.string(), "",
                     fmt::format("has no cell in common with {}", arguments.before.string()),
                     "give two runs that measured the same instance with the same strategy and options");
  const ComparisonTables shown =
      build_comparison(comparison, arguments.before.string(), arguments.after.string());
  if (arguments.out) write_tables(shown.tables, *arguments.out);
  std::cout << shown_on_terminal(shown.tables, shown.lines);
  return comparison.has_regressed() ? ExitCode::check_failed : ExitCode::done;
}

}  // namespace

void add_compare_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = app.add_subcommand("compare", "Hold two stored runs against each other");
  command->add_option("RUN_A", arguments->before, "The run to compare with: a run.json, or its folder")
      ->type_name("RUN")
      ->required();
  command->add_option("RUN_B", arguments->after, "The run to judge, likewise")->type_name("RUN")->required();
  command
      ->add_option("--margin", arguments->margin_percent,
                   "Medians that differ by less are alike: two runs of one program do, too")
      ->check(number_between(0, 1e6, "a percentage from 0 to 1000000"))
      ->type_name("PERCENT")
      ->capture_default_str();
  command->add_option("--out", arguments->out, "Folder for the tables as Markdown, CSV and LaTeX")
      ->check(place_name())
      ->type_name("DIR");
  command->footer(
      "Any two runs of tables, precision or stability: what they were made with, answers, times and work "
      "that\n"
      "differ, and cells that only one has. A time is slower or faster when it differs by more\n"
      "than --margin, by an interval that holds for all cells together with 95 %, which takes more "
      "repetitions\n"
      "the more cells there are.\n"
      "\nThe exit code is 1 when B has regressed: a status, claim, count, proof or accuracy is worse, or a "
      "time\n"
      "on the same processor slower.\n"
      "\nExample:\n"
      "  gcsbench tables all --out before\n"
      "  gcsbench tables all --out after\n"
      "  gcsbench compare before after\n");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return compare(*arguments); }; });
}

}  // namespace gcs
