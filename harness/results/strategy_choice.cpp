#include "harness/results/strategy_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "harness/base/errors.hpp"
#include "harness/results/exec_strategy.hpp"
#include "solvers/reading/nearest_name.hpp"

namespace gcs {

namespace {

template <typename Named>
std::vector<std::string> names_of(std::span<const Named> all) {
  std::vector<std::string> names;
  for (const Named& one : all) names.emplace_back(one.name);
  return names;
}

template <typename Named>
const Named* find_named(std::span<const Named> all, std::string_view name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
}

[[noreturn]] void refuse_option(const StrategyEntry& entry, const std::string& name) {
  const auto names = names_of(std::span<const OptionSpec>(entry.options));
  if (names.empty())
    throw UsageError(fmt::format("strategy {} has no options, and so no '{}'", entry.name, name));
  throw UsageError(fmt::format("strategy {} has no option '{}'; did you mean '{}'? Its options are {}",
                               entry.name, name, nearest_name(name, names), quoted_list(names)));
}

}  // namespace

const StrategyEntry& find_strategy(std::string_view name) {
  if (const StrategyEntry* entry = find_named(all_strategies(), name)) return *entry;
  for (const LeftOutPart& part : left_out_parts())
    if (part.name == fmt::format("strategy {}", name))
      throw UsageError(
          fmt::format("strategy {} is off in this build; build with -D{}=ON", name, part.option));
  const auto names = names_of(all_strategies());
  throw UsageError(fmt::format("there is no strategy '{}'; did you mean '{}'? The strategies are {}", name,
                               nearest_name(name, names), quoted_list(names)));
}

StrategyEntry find_strategy_or_program(const std::string& name) {
  return exec_command(name) ? exec_entry(name) : find_strategy(name);
}

OptionMap parse_settings(const StrategyEntry& entry, std::span<const std::string> settings) {
  OptionMap options;
  for (const std::string& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
      throw UsageError(fmt::format("--set {}: expected option=value", setting));
    const std::string name = setting.substr(0, equals);
    if (!find_named(std::span<const OptionSpec>(entry.options), name)) refuse_option(entry, name);
    if (!options.emplace(name, setting.substr(equals + 1)).second)
      throw UsageError(fmt::format("--set {}: option '{}' is given twice", setting, name));
  }
  entry.make(complete_options(entry, options));  // throws
  return options;
}

}  // namespace gcs
