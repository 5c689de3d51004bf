/// gcsbench list: what there is.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "harness/commands.hpp"
#include "harness/instance_io.hpp"
#include "harness/json_build.hpp"
#include "solvers/strategy.hpp"

namespace gcs {

namespace {

struct ListArguments {
  std::string what;  ///< "instances", "strategies", or empty for both
  bool json = false;
};

std::vector<Instance> all_instances() {
  std::vector<Instance> instances;
  for (const std::string& id : shipped_instances()) instances.push_back(load_instance(id));
  return instances;
}

JsonValue instances_value(const std::vector<Instance>& instances) {
  std::vector<JsonValue> values;
  for (const Instance& instance : instances)
    values.push_back(json_object({{"id", json_text(instance.id)},
                                  {"title", json_text(instance.title)},
                                  {"dimension", json_count(instance.problem.dimension)},
                                  {"points", json_count(instance.problem.points.size())},
                                  {"lines", json_count(instance.problem.lines.size())},
                                  {"constraints", json_count(instance.problem.constraints.size())},
                                  {"sketch", json_boolean(instance.problem.sketch.has_value())}}));
  return json_array(std::move(values));
}

JsonValue option_value(const OptionSpec& option) {
  return json_object({{"name", json_text(std::string(option.name))},
                      {"default", json_text(option.default_value)},
                      {"allowed", json_text(std::string(option.allowed))},
                      {"summary", json_text(std::string(option.summary))}});
}

JsonValue strategies_value() {
  std::vector<JsonValue> values;
  for (const StrategyEntry& entry : all_strategies()) {
    std::vector<JsonValue> options;
    for (const OptionSpec& option : entry.options) options.push_back(option_value(option));
    values.push_back(json_object({{"name", json_text(std::string(entry.name))},
                                  {"summary", json_text(std::string(entry.summary))},
                                  {"citation", json_text(std::string(entry.citation))},
                                  {"needs_sketch", json_boolean(entry.needs_sketch)},
                                  {"options", json_array(std::move(options))}}));
  }
  return json_array(std::move(values));
}

template <typename Items, typename NameOf>
std::size_t widest(const Items& items, NameOf name_of) {
  std::size_t width = 0;
  for (const auto& item : items) width = std::max(width, name_of(item).size());
  return width;
}

void print_instances(const std::vector<Instance>& instances) {
  const std::size_t width = widest(instances, [](const Instance& instance) { return instance.id; });
  for (const Instance& instance : instances) {
    const Problem& problem = instance.problem;
    std::cout << fmt::format("{:{}}  {}D  {:3} constraints  {}  {}\n", instance.id, width, problem.dimension,
                             problem.constraints.size(), problem.sketch ? "sketch   " : "no sketch",
                             instance.title);
  }
}

void print_strategies() {
  const std::size_t width = widest(all_strategies(), [](const StrategyEntry& entry) { return entry.name; });
  for (const StrategyEntry& entry : all_strategies())
    std::cout << fmt::format("{:{}}  {}\n", entry.name, width, entry.summary);
}

JsonValue left_out_value() {
  std::vector<JsonValue> values;
  for (const LeftOutPart& part : left_out_parts())
    values.push_back(json_object(
        {{"name", json_text(std::string(part.name))}, {"option", json_text(std::string(part.option))}}));
  return json_array(std::move(values));
}

void print_left_out() {
  for (const LeftOutPart& part : left_out_parts())
    std::cout << fmt::format("off in this build: {} (cmake -D{}=ON brings it back)\n", part.name,
                             part.option);
}

void print_json(const ListArguments& arguments) {
  JsonMembers members;
  if (arguments.what != "strategies") members.emplace_back("instances", instances_value(all_instances()));
  if (arguments.what != "instances") members.emplace_back("strategies", strategies_value());
  if (arguments.what.empty()) members.emplace_back("left_out", left_out_value());
  std::cout << to_text(json_object(std::move(members)), 1) << '\n';
}

void print_text(const ListArguments& arguments) {
  const bool both = arguments.what.empty();
  if (both) std::cout << "instances:\n";
  if (arguments.what != "strategies") print_instances(all_instances());
  if (both) std::cout << "\nstrategies:\n";
  if (arguments.what != "instances") print_strategies();
  if (arguments.what != "instances") print_left_out();
}

ExitCode list(const ListArguments& arguments) {
  arguments.json ? print_json(arguments) : print_text(arguments);
  return ExitCode::done;
}

}  // namespace

void add_list_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ListArguments>();
  CLI::App* command = app.add_subcommand("list", "What there is: instances and strategies");
  command->add_option("WHAT", arguments->what, "instances or strategies; both when it is left out")
      ->check(CLI::IsMember({"instances", "strategies"}));
  command->add_flag("--json", arguments->json, "As JSON, with every option of every strategy");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return list(*arguments); }; });
}

}  // namespace gcs
