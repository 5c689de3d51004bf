#include "solvers/interface/options.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace gcs {
namespace {

/// "1e-07" is written "1e-7", and "1e+06" "1e6".
std::string without_padding(std::string_view decimal) {
  const auto exponent = decimal.find('e');
  if (exponent == std::string_view::npos) return std::string(decimal);
  const std::string sign = decimal[exponent + 1] == '-' ? "-" : "";
  const auto digits = decimal.find_first_not_of('0', exponent + 2);
  return std::string(decimal.substr(0, exponent + 1)) + sign + std::string(decimal.substr(digits));
}

}  // namespace

template <class Number>
std::string Range<Number>::allowed() const {
  return (std::is_integral_v<Number> ? "a whole number from " : "a number from ") + text(low) + " to " +
         text(high);
}

template <class Number>
std::optional<Number> Range<Number>::read(std::string_view text) const {
  Number value{};
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const bool is_allowed = error == std::errc() && rest == end && value >= low && value <= high;
  return is_allowed ? std::optional(value) : std::nullopt;
}

template <class Number>
std::string Range<Number>::text(Number value) {
  std::array<char, 32> digits;
  const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  return without_padding({digits.data(), end});
}

template struct Range<int>;
template struct Range<std::int64_t>;
template struct Range<double>;

std::optional<int> number_of_word(std::string_view words, std::string_view word) {
  int number = 0;
  for (std::size_t begin = 0; begin <= words.size(); ++number) {
    const std::size_t end = std::min(words.find('|', begin), words.size());
    if (words.substr(begin, end - begin) == word) return number;
    begin = end + 1;
  }
  return std::nullopt;
}

std::string_view word_of_number(std::string_view words, int number) {
  if (number < 0) return {};
  for (; number > 0; --number) {
    const std::size_t end = words.find('|');
    if (end == std::string_view::npos) return {};
    words.remove_prefix(end + 1);
  }
  return words.substr(0, words.find('|'));
}

std::optional<bool> OnOff::read(std::string_view text) {
  if (text == "on") return true;
  if (text == "off") return false;
  return std::nullopt;
}

std::optional<AutoOr::Value> AutoOr::read(std::string_view text) const {
  if (text == "auto") return Value();
  const std::optional<double> number = range.read(text);
  return number ? std::optional<Value>(number) : std::nullopt;
}

std::optional<FileName::Value> FileName::read(std::string_view text) {
  if (text.empty()) return std::nullopt;
  return text == "none" ? Value() : Value(text);
}

void refuse_value(std::string_view name, std::string_view text, const std::string& allowed,
                  std::string_view hint) {
  throw OptionError("option " + std::string(name) + "=" + std::string(text) + ": expected " + allowed +
                    (hint.empty() ? "" : "; ") + std::string(hint));
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
