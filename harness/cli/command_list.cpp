/// gcsbench list: what there is.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "harness/cli/commands.hpp"
#include "harness/instances/families.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

namespace {

struct ListArguments {
  std::string what;  ///< "instances", "families" or "strategies"; empty: everything
  bool json = false;
};

struct FoundInstances {
  std::vector<Instance> readable;
  std::vector<std::string> messages;  ///< what is wrong with the others
};

FoundInstances find_instances() {
  FoundInstances found;
  for (const std::string& id : shipped_instances()) try {
      found.readable.push_back(load_instance(id));
    } catch (const InputError& error) {
      found.messages.emplace_back(error.what());
    }
  return found;
}

std::vector<InstanceFamily> families_of_all_kinds() {
  std::vector<InstanceFamily> all;
  for (const auto kind : all_families()) all.insert(all.end(), kind.begin(), kind.end());
  return all;
}

/// "@1, @2, @5"; of many the first and the last.
std::string members_text(const InstanceFamily& family) {
  constexpr std::size_t most_listed = 12;
  return family.values.size() <= most_listed
             ? fmt::format("@{}", fmt::join(family.values, ", @"))
             : fmt::format("@{} to @{}", family.values.front(), family.values.back());
}

std::size_t constraint_count(const ProblemStatement& problem) {
  return problem.constraints.size() + problem.relations.size();
}

JsonValue instances_value(const std::vector<Instance>& instances) {
  std::vector<JsonValue> values;
  for (const Instance& instance : instances)
    values.push_back(json_object({{"id", json_text(instance.id)},
                                  {"title", json_text(instance.title)},
                                  {"dimension", json_count(instance.problem.dimension)},
                                  {"points", json_count(instance.problem.points.size())},
                                  {"lines", json_count(instance.problem.lines.size())},
                                  {"constraints", json_count(constraint_count(instance.problem))},
                                  {"sketch", json_boolean(instance.problem.sketch.has_value())}}));
  return json_array(std::move(values));
}

JsonValue families_value() {
  std::vector<JsonValue> values;
  for (const InstanceFamily& family : families_of_all_kinds())
    values.push_back(json_object({{"name", json_text(std::string(family.name))},
                                  {"summary", json_text(std::string(family.summary))},
                                  {"members", json_texts(family.members())}}));
  return json_array(std::move(values));
}

JsonValue option_value(const OptionSpec& option) {
  return json_object({{"name", json_text(std::string(option.name))},
                      {"default", json_text(option.default_value)},
                      {"allowed", json_text(option.allowed)},
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
    const ProblemStatement& problem = instance.problem;
    std::cout << fmt::format("{:{}}  {}D  {:3} constraints  {}  {}\n", instance.id, width, problem.dimension,
                             constraint_count(problem), problem.sketch ? "sketch   " : "no sketch",
                             instance.title);
  }
}

void print_families() {
  const std::vector<InstanceFamily> all = families_of_all_kinds();
  const std::size_t width = widest(all, [](const InstanceFamily& family) { return family.name; });
  for (const InstanceFamily& family : all)
    std::cout << fmt::format("{:{}}  {}: {}\n", family.name, width, family.summary, members_text(family));
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

/// In this order.
constexpr std::array kinds{"instances", "families", "strategies"};

bool shows(const ListArguments& arguments, std::string_view kind) {
  return arguments.what.empty() || arguments.what == kind;
}

void print_json(const ListArguments& arguments, const std::vector<Instance>& instances) {
  JsonMembers members;
  if (shows(arguments, "instances")) members.emplace_back("instances", instances_value(instances));
  if (shows(arguments, "families")) members.emplace_back("families", families_value());
  if (shows(arguments, "strategies")) members.emplace_back("strategies", strategies_value());
  if (arguments.what.empty()) members.emplace_back("left_out", left_out_value());
  std::cout << to_text(json_object(std::move(members)), 1) << '\n';
}

void print_text(const ListArguments& arguments, const std::vector<Instance>& instances) {
  const char* separator = "";
  for (const std::string_view kind : kinds) {
    if (!shows(arguments, kind)) continue;
    if (arguments.what.empty()) std::cout << separator << kind << ":\n";
    separator = "\n";
    if (kind == "instances") print_instances(instances);
    if (kind == "families") print_families();
    if (kind == "strategies") print_strategies();
  }
  if (shows(arguments, "strategies")) print_left_out();
}

ExitCode list(const ListArguments& arguments) {
  const FoundInstances found = shows(arguments, "instances") ? find_instances() : FoundInstances{};
  arguments.json ? print_json(arguments, found.readable) : print_text(arguments, found.readable);
  std::cout.flush();
  for (const std::string& message : found.messages) std::cerr << "gcsbench: " << message << '\n';
  return found.messages.empty() ? ExitCode::done : ExitCode::bad_input;
}

}  // namespace

void add_list_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ListArguments>();
  CLI::App* command =
      app.add_subcommand("list", "What there is: instances, families of them, and strategies");
  command
      ->add_option(
          "WHAT", arguments->what,
          "instances, families (of which any member may be given as INSTANCE) or strategies; all when it "
          "is left out")
      ->check(CLI::IsMember({"instances", "families", "strategies"}));
  command->add_flag("--json", arguments->json, "As JSON, with every option of every strategy");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return list(*arguments); }; });
}

}  // namespace gcs
