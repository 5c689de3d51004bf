/// gcsbench stability: stiff and extreme families.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "harness/base/stop_conditions.hpp"
#include "harness/cli/measurement_options.hpp"
#include "harness/instances/families.hpp"
#include "solvers/reading/nearest_name.hpp"

namespace gcs {

namespace {

/// All families, in a quarter of an hour to half an hour.
constexpr TimingLimits limits{
    .budget_s = 120, .cell_limit_s = 10, .total_limit_s = 2700, .skips_variants = true};

std::vector<std::string> family_names() {
  std::vector<std::string> names;
  for (const InstanceFamily& family : families()) names.emplace_back(family.name);
  return names;
}

std::vector<std::string> members_of(const std::vector<std::string>& names) {
  const std::vector<std::string> known = family_names();
  std::vector<std::string> members;
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UsageError(
          fmt::format("there is no family '{}'; did you mean '{}'?", name, nearest_name(name, known)));
    for (std::string& id : find_family(name)->members()) members.push_back(std::move(id));
  }
  return members;
}

/// A strategy that calls an answer complete, or infinitely many, which is not right.
bool has_wrong_claim(const RunFile& run) {
  return std::any_of(run.cells.begin(), run.cells.end(), [](const CellRecord& cell) {
    return (cell.status == RunStatus::complete && cell.is_flawed()) ||
           (cell.status == RunStatus::infinite && !is_ill_posed(cell.spec.instance));
  });
}

ExitCode stability(TableRequest request, const std::vector<std::string>& names,
                   const Invocation& invocation) {
  request.tables = {std::string(stability_kind().name)};
  request.instances = members_of(names);
  const RunFile run = measure_and_show(std::move(request), {}, invocation);
  if (interrupted()) return ExitCode::interrupted;
  return has_wrong_claim(run) ? ExitCode::check_failed : ExitCode::done;
}

std::string families_help() {
  std::string text = "Families:\n";
  for (const InstanceFamily& family : families())
    text += fmt::format("  {:18} {}\n", family.name, family.summary);
  return text +
         "\nEvery strategy that can do an instance is held against proven solutions. The exit code is 1 when "
         "one "
         "calls an answer complete that misses a solution or lists one that is none, or infinite where it is "
         "not.\n" +
         resume_help +
         "\nExamples:\n"
         "  gcsbench stability flat-tetrahedron\n"
         "  gcsbench stability --out results/runs/stability\n";
}

}  // namespace

void add_stability_command(CLI::App& app, Invocation& invocation) {
  const auto request = std::make_shared<TableRequest>();
  request->limits = limits;
  const auto names = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("stability", "Measure the stiff and extreme families");
  command->add_option("FAMILY", *names, "Which families; see below. Default: all");
  add_measuring_options(*command, "the tables and the heat map", *request);
  command->footer(families_help);
  command->callback([&invocation, request, names] {
    invocation.action = [&invocation, request, names] { return stability(*request, *names, invocation); };
  });
}

}  // namespace gcs
