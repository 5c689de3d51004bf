#include "harness/cli/completion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <set>

#include "harness/instances/families.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

namespace {

using Words = std::vector<std::string>;

template <typename Entries>
Words names_of(const Entries& entries) {
  Words names;
  for (const auto& entry : entries) names.emplace_back(entry.name);
  return names;
}

Words joined(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// A family's members once its name stands, for they are many.
Words instance_names(const std::string& current) {
  const InstanceFamily* family = find_family(current.substr(0, current.find('@')));
  return family != nullptr ? family->members() : joined(shipped_instances(), names_of(families()));
}

/// Of the strategy that was chosen: "mode=", and once that stands "mode=fast" and so on where values are words.
Words settings(const Words& before, const std::string& current) {
  Words found;
  for (const StrategyEntry& entry : all_strategies()) {
    const Words choice{"--strategy", std::string(entry.name)};
    if (std::search(before.begin(), before.end(), choice.begin(), choice.end()) == before.end()) continue;
    for (const OptionSpec& option : entry.options) {
      const std::string start = std::string(option.name) + "=";
      if (!current.starts_with(start)) found.push_back(start);
      if (!current.starts_with(start) || option.allowed.find(' ') != std::string::npos) continue;
      for (const std::string& value : CLI::detail::split(option.allowed, '|')) found.push_back(start + value);
    }
  }
  return found;
}

Words values_of(const CLI::Option& option, const Words& before, const std::string& current) {
  const std::string name = option.get_name(), type = option.get_type_name();
  if (name == "--strategy" || name == "--strategies") return names_of(all_strategies());
  if (name == "INSTANCE" || name == "--instances") return instance_names(current);
  if (name == "FAMILY") return names_of(families());
  if (name == "--set") return settings(before, current);
  // The library shows the words of a check for membership as {a,b}.
  const std::size_t open = type.find('{'), close = type.find('}', open);
  return close == std::string::npos ? Words()
                                    : CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

/// Where values are listed with commas, those before the last comma stand.
Words listed_values_of(const CLI::Option& option, const Words& before, const std::string& current) {
  const std::size_t start = option.get_delimiter() == ',' ? current.rfind(',') + 1 : 0;
  Words values = values_of(option, before, current.substr(start));
  for (std::string& value : values) value.insert(0, current, 0, start);
  return values;
}

Words candidates(const CLI::App& program, const Words& before, const std::string& current) {
  for (const CLI::App* command : program.get_subcommands({})) {
    if (std::find(before.begin(), before.end(), command->get_name()) == before.end()) continue;
    Words words;
    for (const CLI::Option* option : command->get_options()) {
      const bool takes_value = option->nonpositional() && option->get_items_expected_max() > 0;
      if (takes_value && option->get_name() == before.back())
        return listed_values_of(*option, before, current);
      if (option->get_positional()) words = joined(words, listed_values_of(*option, before, current));
    }
    if (!current.starts_with('-')) return words;
    return joined(words, joined(option_names(*command), option_names(program)));
  }
  return joined(command_names(program), option_names(program));
}

}  // namespace

Words option_names(const CLI::App& app) {
  Words names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

Words command_names(const CLI::App& program) {
  Words names;
  for (const CLI::App* command : program.get_subcommands({}))
    if (!command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> completions(const CLI::App& program, const std::vector<std::string>& words) {
  const std::string current = words.empty() ? "" : words.back();
  const Words before(words.begin(), words.end() - (words.empty() ? 0 : 1));
  std::set<std::string> found;
  for (const std::string& word : candidates(program, before, current))
    if (word.starts_with(current)) found.insert(word);
  return {found.begin(), found.end()};
}

}  // namespace gcs
