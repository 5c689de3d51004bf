/// gcsbench count: how many complex solutions there are at generic lengths, without solving.

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/solving/counts_view.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

namespace {

struct CountArguments {
  std::string instance;
  bool json = false;
};

std::string json_counts(const Instance& instance, const TheoreticalCounts& counts) {
  JsonMembers members{{"id", json_text(instance.id)}};
  JsonValue value = counts_value(instance.problem, counts);
  for (auto& member : value.members) members.push_back(std::move(member));
  return to_text(json_object(std::move(members)), 1) + "\n";
}

ExitCode count(const CountArguments& arguments) {
  const Instance instance = load_instance(arguments.instance);
  const TheoreticalCounts counts = theoretical_counts(instance.problem);
  std::cout << (arguments.json ? json_counts(instance, counts) : counts_text(instance.problem, counts));
  return ExitCode::done;
}

}  // namespace

void add_count_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<CountArguments>();
  CLI::App* command =
      app.add_subcommand("count", "How many complex solutions there are at generic lengths, without solving");
  add_instance_argument(*command, arguments->instance);
  command->add_flag("--json", arguments->json, "As JSON");
  command->footer("Example:\n  gcsbench count dodecagon\n");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return count(*arguments); }; });
}

}  // namespace gcs
