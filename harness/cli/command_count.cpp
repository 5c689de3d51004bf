/// gcsbench count: how many complex solutions there are at generic lengths, without solving.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/base/stop_conditions.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/solving/counts_view.hpp"
#include "solvers/counting/sphere_count.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

namespace {

/// Of the recursions: a minute or so, for some hundred megabytes of what they remember.
constexpr std::int64_t most_steps = 40'000'000;

const std::string sphere = "sphere";

struct CountArguments {
  std::string instance;
  std::string on = "plane";
  bool json = false;
};

std::string json_counts(const Instance& instance, const TheoreticalCounts& counts) {
  JsonMembers members{{"id", json_text(instance.id)}};
  JsonValue value = counts_value(instance.problem, counts);
  for (auto& member : value.members) members.push_back(std::move(member));
  return to_text(json_object(std::move(members)), 1) + "\n";
}

std::string json_count_on_sphere(const Instance& instance, const SphereCount& count) {
  const auto value = [](const SolutionCount& exact) {
    return json_object({{"fixed_frame", json_count(exact.fixed_frame)},
                        {"up_to_reflection", json_count(exact.up_to_reflection())}});
  };
  const JsonValue reason = count.exact ? json_null() : json_text(count.why_no_exact);
  return to_text(json_object({{"id", json_text(instance.id)},
                              {"on", json_text(sphere)},
                              {"exact", json_or_null(count.exact, value)},
                              {"why_no_exact", reason}}),
                 1) +
         "\n";
}

std::string text_of_count_on_sphere(const SphereCount& count) {
  return row("on the sphere", count.exact ? fmt::format("exactly {} in the fixed frame, {} up to reflection",
                                                        readable(count.exact->fixed_frame),
                                                        readable(count.exact->up_to_reflection()))
                                          : "not known: " + count.why_no_exact);
}

ExitCode count(const CountArguments& arguments) {
  const Instance instance = load_instance(arguments.instance);
  catch_interrupts();
  const StopWatch watch(std::nullopt);
  const RecursionLimits limits{.steps = most_steps, .stop = watch.token()};
  if (arguments.on == sphere) {
    const SphereCount count = sphere_count(instance.problem, limits);
    std::cout << (arguments.json ? json_count_on_sphere(instance, count) : text_of_count_on_sphere(count));
  } else {
    const TheoreticalCounts counts = theoretical_counts(instance.problem, limits);
    std::cout << (arguments.json ? json_counts(instance, counts) : counts_text(instance.problem, counts));
  }
  return interrupted() ? ExitCode::interrupted : ExitCode::done;
}

}  // namespace

void add_count_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<CountArguments>();
  CLI::App* command =
      app.add_subcommand("count", "How many complex solutions there are at generic lengths, without solving");
  add_instance_argument(*command, arguments->instance);
  command
      ->add_option("--on", arguments->on,
                   "plane: the scene as it is, also in space; sphere: points of the plane on the "
                   "unit sphere instead, with generic distances")
      ->check(CLI::IsMember(std::vector<std::string>{"plane", sphere}))
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "As JSON");
  command->footer("Examples:\n  gcsbench count dodecagon\n  gcsbench count prism --on sphere\n");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return count(*arguments); }; });
}

}  // namespace gcs
