/// gcsbench precision: error against run time.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "harness/base/stop_conditions.hpp"
#include "harness/cli/measurement_options.hpp"

namespace gcs {

namespace {

/// All shipped instances in less than 15 minutes.
constexpr TimingLimits limits{
    .budget_s = 240, .cell_limit_s = 10, .total_limit_s = 700, .skips_variants = true};

/// Settings beside the defaults are experiments, whose failures are findings.
bool has_flawed_default(const RunFile& run) {
  return std::any_of(run.cells.begin(), run.cells.end(), [](const CellRecord& cell) {
    return cell.spec.given.empty() && cell.status == RunStatus::complete && cell.is_flawed();
  });
}

bool has_answer(const RunFile& run) {
  return std::any_of(run.cells.begin(), run.cells.end(),
                     [](const CellRecord& cell) { return cell.status == RunStatus::complete; });
}

ExitCode precision(TableRequest request, const Invocation& invocation) {
  request.tables = {std::string(precision_kind().name)};
  const RunFile run = measure_and_show(std::move(request), {}, invocation);
  if (interrupted()) return ExitCode::interrupted;
  if (has_flawed_default(run)) return ExitCode::check_failed;
  return has_answer(run) ? ExitCode::done : ExitCode::not_solved;
}

}  // namespace

void add_precision_command(CLI::App& app, Invocation& invocation) {
  const auto request = std::make_shared<TableRequest>();
  request->limits = limits;
  CLI::App* command = app.add_subcommand("precision", "Measure error against run time");
  command->add_option("INSTANCE", request->instances, "Ids or files; default: all shipped instances");
  add_measuring_options(*command, "the tables and plots", *request);
  command->footer(
      std::string(
          "Every strategy that can do an instance is measured with its defaults, with each of its accuracy\n"
          "settings, and refined to 30, 60 and 100 digits. Answers are held against proven solutions: those "
          "in\n"
          "results/reference, or for other instances those that are proven in this run.\n"
          "\nThe exit code is 1 when a strategy with its defaults misses a solution that it claims to find "
          "or\n"
          "lists one that is none, and 3 when none has an answer.\n") +
      resume_help +
      "\nExamples:\n"
      "  gcsbench precision octahedron\n"
      "  gcsbench precision --out results/runs/precision\n");
  command->callback([&invocation, request] {
    invocation.action = [&invocation, request] { return precision(*request, invocation); };
  });
}

}  // namespace gcs
