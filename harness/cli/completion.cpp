#include "harness/cli/completion.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <string_view>

#include "harness/instances/families.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

namespace {

using Words = std::vector<std::string>;

void append(Words& words, const Words& more) { words.insert(words.end(), more.begin(), more.end()); }

Words split(std::string_view text, char separator) {
  Words parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    parts.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

Words strategy_names() {
  Words names;
  for (const StrategyEntry& entry : all_strategies()) names.emplace_back(entry.name);
  return names;
}

Words family_names() {
  Words names;
  for (const InstanceFamily& family : families()) names.emplace_back(family.name);
  return names;
}

/// A family's members once its name stands, for they are many.
Words instance_names(const std::string& current) {
  const InstanceFamily* family = find_family(current.substr(0, current.find('@')));
  if (family != nullptr) return family->members();
  Words names = shipped_instances();
  append(names, family_names());
  return names;
}

const StrategyEntry* strategy_in(const Words& words) {
  const auto option = std::find(words.begin(), words.end(), "--strategy");
  if (option == words.end() || std::next(option) == words.end()) return nullptr;
  const auto entries = all_strategies();
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const StrategyEntry& one) { return one.name == *std::next(option); });
  return entry == entries.end() ? nullptr : &*entry;
}

/// "mode=", and once that stands "mode=fast" and so on where the values are words.
Words settings(const StrategyEntry& entry, const std::string& current) {
  Words found;
  for (const OptionSpec& option : entry.options) {
    const std::string start = std::string(option.name) + "=";
    const bool are_words = option.allowed.find(' ') == std::string_view::npos;
    if (!current.starts_with(start)) {
      found.push_back(start);
    } else if (are_words) {
      for (const std::string& value : split(option.allowed, '|')) found.push_back(start + value);
    }
  }
  return found;
}

/// The words of a check for membership, which the library shows as {a,b}.
Words words_in_braces(const std::string& type) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return split(std::string_view(type).substr(open + 1, close - open - 1), ',');
}

Words values_of(const CLI::Option& option, const Words& before, const std::string& current) {
  const std::string name = option.get_name();
  if (name == "--strategy" || name == "--strategies") return strategy_names();
  if (name == "INSTANCE" || name == "--instances") return instance_names(current);
  if (name == "FAMILY") return family_names();
  if (name == "--set") {
    const StrategyEntry* entry = strategy_in(before);
    return entry == nullptr ? Words() : settings(*entry, current);
  }
  return words_in_braces(option.get_type_name());
}

/// Where values are listed with commas, those before the last comma stand.
Words listed_values_of(const CLI::Option& option, const Words& before, const std::string& current) {
  const std::size_t comma = option.get_delimiter() == ',' ? current.rfind(',') : std::string::npos;
  const std::size_t start = comma == std::string::npos ? 0 : comma + 1;
  Words values = values_of(option, before, current.substr(start));
  for (std::string& value : values) value.insert(0, current, 0, start);
  return values;
}

const CLI::App* command_in(const CLI::App& program, const Words& words) {
  for (const CLI::App* command : program.get_subcommands({}))
    if (std::find(words.begin(), words.end(), command->get_name()) != words.end()) return command;
  return nullptr;
}

/// The option that awaits its value, or nullptr.
const CLI::Option* awaiting(const CLI::App& command, const Words& before) {
  for (const CLI::Option* option : command.get_options())
    if (option->nonpositional() && option->get_items_expected_max() > 0 &&
        option->get_name() == before.back())
      return option;
  return nullptr;
}

Words candidates(const CLI::App& program, const Words& before, const std::string& current) {
  const CLI::App* command = command_in(program, before);
  if (command == nullptr) {
    Words words = command_names(program);
    append(words, option_names(program));
    return words;
  }
  if (const CLI::Option* option = awaiting(*command, before))
    return listed_values_of(*option, before, current);
  Words words;
  for (const CLI::Option* option : command->get_options())
    if (option->get_positional()) append(words, listed_values_of(*option, before, current));
  if (!current.starts_with('-')) return words;
  append(words, option_names(*command));
  append(words, option_names(program));
  return words;
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
  const Words before(words.begin(), words.empty() ? words.end() : std::prev(words.end()));
  Words found = candidates(program, before, current);
  std::erase_if(found, [&](const std::string& word) { return !word.starts_with(current); });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace gcs
