/// gcsbench tables: measures and prints the published tables beside this program's figures.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "harness/base/stop_conditions.hpp"
#include "harness/cli/measurement_options.hpp"

namespace gcs {

namespace {

constexpr const char* everything = "all";

std::vector<std::string> table_names() {
  std::vector<std::string> names;
  for (const TableKind& kind : table_kinds()) names.emplace_back(kind.name);
  return names;
}

/// "all", or nothing, stands for every table.
void expand_names(std::vector<std::string>& names) {
  const bool all = names.empty() || std::find(names.begin(), names.end(), everything) != names.end();
  if (all) names = table_names();
}

/// An instance that is out of reach of every strategy that was asked for.
bool any_out_of_reach(const RunFile& run) {
  return std::any_of(run.instances.begin(), run.instances.end(), [&](const InstanceSummary& instance) {
    bool measured = false;
    bool reached = false;
    for (const CellRecord& cell : run.cells) {
      if (cell.spec.instance != instance.id) continue;
      measured = true;
      reached = reached || cell.status != RunStatus::unsupported;
    }
    return measured && !reached;
  });
}

/// The defaults of every strategy are held to the answer wherever they can do the instance; variants are
/// experiments, whose failures are findings.
ExitCode exit_code(const RunFile& run) {
  if (interrupted()) return ExitCode::interrupted;
  if (run.cells.empty()) return ExitCode::not_solved;  // all tables need what is off in this build
  const auto any_default = [&](auto holds) {
    return std::any_of(run.cells.begin(), run.cells.end(),
                       [&](const CellRecord& cell) { return cell.spec.given.empty() && holds(cell); });
  };
  if (any_default([](const CellRecord& cell) { return !cell.difference.empty(); }))
    return ExitCode::check_failed;
  const auto has_no_answer = [](const CellRecord& cell) {
    return !cell.is_right() && cell.status != RunStatus::unsupported && cell.status != RunStatus::timed_out;
  };
  if (any_default(has_no_answer) || any_out_of_reach(run)) return ExitCode::not_solved;
  return ExitCode::done;
}

ExitCode tables(TableRequest request, const Invocation& invocation) {
  expand_names(request.tables);
  return exit_code(measure_and_show(std::move(request), load_publications(), invocation));
}

std::string names_help() {
  std::string text = "Tables:\n";
  for (const TableKind& kind : table_kinds()) text += fmt::format("  {:14} {}\n", kind.name, kind.summary);
  return text + fmt::format("  {:14} all of them (the default)\n", everything) +
         "\nA wrong answer gets no time. The exit code is 1 when a strategy with its default options is "
         "wrong, and 3 "
         "when one has no answer or none can do an instance; other options are experiments. What would take "
         "longer than "
         "a solve may is not run, and no failure: --full runs it.\n" +
         resume_help +
         "\nExamples:\n"
         "  gcsbench tables table1\n"
         "  gcsbench tables all --out results/runs/today\n"
         "  gcsbench tables table2 --instances disulfide,k33 --repetitions 20\n"
         "  gcsbench tables general --instances platform,./mine.json --strategies polyhedral --out page\n";
}

void add_options(CLI::App& command, TableRequest& request) {
  std::vector<std::string> names = table_names();
  names.emplace_back(everything);
  command.add_option("NAME", request.tables, "Which tables; see below")->check(CLI::IsMember(names));
  command.add_option("--instances", request.instances, "Only these: ids or files, separated by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("INSTANCE,...");
  add_measuring_options(command, "the tables as Markdown, CSV and LaTeX", request);
  command.footer(names_help);
}

}  // namespace

void add_tables_command(CLI::App& app, Invocation& invocation) {
  const auto request = std::make_shared<TableRequest>();
  CLI::App* command = app.add_subcommand("tables", "Measure and print the published tables beside ours");
  add_options(*command, *request);
  command->callback([&invocation, request] {
    invocation.action = [&invocation, request] { return tables(*request, invocation); };
  });
}

}  // namespace gcs
