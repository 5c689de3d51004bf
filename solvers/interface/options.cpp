#include "solvers/interface/options.hpp"

#include <charconv>
#include <cmath>
#include <sstream>

namespace gcs {
namespace {

[[noreturn]] void refuse(std::string_view name, const std::string& value, const std::string& expected) {
  throw OptionError("option " + std::string(name) + "=" + value + ": expected " + expected);
}

const std::string& value_of(const OptionMap& options, std::string_view name) {
  return options.find(name)->second;
}

template <class Number>
Number parse(const OptionMap& options, std::string_view name, Number low, Number high) {
  const std::string& text = value_of(options, name);
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= low && value <= high)) {
    std::ostringstream expected;
    expected << (std::is_integral_v<Number> ? "a whole number" : "a number") << " from " << low << " to "
             << high;
    refuse(name, text, expected.str());
  }
  return value;
}

}  // namespace

double number_option(const OptionMap& options, std::string_view name, double low, double high) {
  return parse<double>(options, name, low, high);
}

std::int64_t integer_option(const OptionMap& options, std::string_view name, std::int64_t low,
                            std::int64_t high) {
  return parse<std::int64_t>(options, name, low, high);
}

int choice_option(const OptionMap& options, std::string_view name, std::string_view allowed) {
  const std::string& text = value_of(options, name);
  int index = 0;
  for (std::size_t begin = 0; begin <= allowed.size(); ++index) {
    const std::size_t end = std::min(allowed.find('|', begin), allowed.size());
    if (allowed.substr(begin, end - begin) == text) return index;
    begin = end + 1;
  }
  refuse(name, text, std::string(allowed));
}

std::optional<std::string> file_option(const OptionMap& options, std::string_view name) {
  const std::string& text = value_of(options, name);
  if (text.empty()) refuse(name, text, "the name of a file, or none");
  return text == "none" ? std::nullopt : std::optional(text);
}

OptionMap complete_options(const StrategyEntry& entry, const OptionMap& given) {
  OptionMap options;
  for (const OptionSpec& spec : entry.options) options[std::string(spec.name)] = spec.default_value;
  for (const auto& [name, value] : given) {
    const auto known = options.find(name);
    if (known == options.end()) {
      std::string names;
      for (const OptionSpec& spec : entry.options)
        names += (names.empty() ? "" : ", ") + std::string(spec.name);
      throw OptionError("strategy " + std::string(entry.name) + " has no option '" + name +
                        "'; it has: " + names);
    }
    known->second = value;
  }
  return options;
}

}  // namespace gcs
