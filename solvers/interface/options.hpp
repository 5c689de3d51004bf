#pragma once
/// The options of a strategy, declared once: a struct whose members are the values, and a function that ties
/// each member to its name, to what is allowed and to a line of help. Help, defaults, checking and the way
/// between texts and values follow from it.
///
///     struct MyIdea {
///       static constexpr std::string_view strategy = "my-idea";
///       std::uint64_t seed = 1;
///       int threads = 1;
///       bool certify = false;
///       std::optional<bool> reduce = {};
///       int starts = 100;
///
///       template <class Self, class Visitor>
///       static void options(Self& self, Visitor&& option) {
///         option("starts", self.starts, Range{1, 1000}, "starts at most");
///       }
///     };
///
/// The first four members are those of every strategy, and no options of its own: who asks for a solve reads
/// them, and `reduce`, empty for its default, is the option that with_reduction adds. Options that several
/// strategies have are a struct with such a function too; that of the strategy calls it.

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

// ---- what an option allows: `allowed` says it in words, `read` gives nothing for a text that is not allowed,
// and `text` is what `read` takes for that value

/// Numbers from `low` to `high`, both included.
template <class Number>
struct Range {
  using Value = Number;
  Number low, high;

  std::string allowed() const;
  std::optional<Number> read(std::string_view text) const;
  /// The shortest decimal that is read as the same number.
  static std::string text(Number value);
};
template <class Number>
Range(Number, Number) -> Range<Number>;
extern template struct Range<int>;
extern template struct Range<std::int64_t>;
extern template struct Range<double>;

/// The number of the word among those that '|' separates, from 0 on.
std::optional<int> number_of_word(std::string_view words, std::string_view word);
/// Empty where there is no such number.
std::string_view word_of_number(std::string_view words, int number);

/// An enumeration: `words` has one word for each enumerator, in their order, separated by '|'.
template <class Enum>
struct OneOf {
  using Value = Enum;
  std::string_view words;

  std::string allowed() const { return std::string(words); }
  std::optional<Enum> read(std::string_view text) const {
    const std::optional<int> number = number_of_word(words, text);
    return number ? std::optional(static_cast<Enum>(*number)) : std::nullopt;
  }
  std::string text(Enum value) const { return std::string(word_of_number(words, static_cast<int>(value))); }
};

struct OnOff {
  using Value = bool;

  static std::string allowed() { return "on|off"; }
  static std::optional<bool> read(std::string_view text);
  static std::string text(bool value) { return value ? "on" : "off"; }
};

/// A number, or nothing for the word "auto".
struct AutoOr {
  using Value = std::optional<double>;
  Range<double> range;

  std::string allowed() const { return "auto, or " + range.allowed(); }
  std::optional<Value> read(std::string_view text) const;
  static std::string text(Value value) { return value ? Range<double>::text(*value) : "auto"; }
};

/// The name of a file, which is not empty, or nothing for the word "none", which names no file.
struct FileName {
  using Value = std::optional<std::string>;

  static std::string allowed() { return "FILE, or none"; }
  static std::optional<Value> read(std::string_view text);
  static std::string text(const Value& value) { return value.value_or("none"); }
};

/// What else there is to say of an option.
struct OptionTraits {
  bool is_length = false;      ///< see OptionSpec
  bool changes_result = true;  ///< see OptionSpec
  std::string_view hint = {};  ///< more about a refused value, in words
};

template <class Rule, class Value>
concept RuleFor = std::same_as<typename Rule::Value, Value>;

template <class Options>
concept StrategyOptions = requires(Options options) {
  { Options::strategy } -> std::convertible_to<std::string_view>;
  { options.seed } -> std::same_as<std::uint64_t&>;
  { options.threads } -> std::same_as<int&>;
  { options.certify } -> std::same_as<bool&>;
  { options.reduce } -> std::same_as<std::optional<bool>&>;
};

// ---- texts and values

inline constexpr std::string_view reduce_option = "reduce";

/// Throws OptionError: the option, its text, what is allowed, and the hint if there is one.
[[noreturn]] void refuse_value(std::string_view name, std::string_view text, const std::string& allowed,
                               std::string_view hint);

/// Reads the option into `value`, which stays where `options` does not name it. Throws OptionError for a text
/// that is not allowed.
template <class Value, RuleFor<Value> Rule>
void read_option(const OptionMap& options, std::string_view name, const Rule& rule, Value& value,
                 std::string_view hint = {}) {
  const auto given = options.find(name);
  if (given == options.end()) return;
  std::optional<Value> read = rule.read(given->second);
  if (!read) refuse_value(name, given->second, rule.allowed(), hint);
  value = std::move(*read);
}

/// The values of these texts, and the defaults of options that are not among them; `seed`, `threads` and
/// `certify` are no texts. Throws OptionError for a text that is not allowed; names that are no option of the
/// strategy are left to complete_options.
template <StrategyOptions Options>
Options read_options(const OptionMap& texts) {
  Options values;
  Options::options(values,
                   [&]<class Value>(std::string_view name, Value& value, const RuleFor<Value> auto& rule,
                                    std::string_view, const OptionTraits& traits = {}) {
                     read_option(texts, name, rule, value, traits.hint);
                   });
  if (texts.contains(reduce_option)) read_option(texts, reduce_option, OnOff{}, values.reduce.emplace());
  return values;
}

/// The text of every option of its own, and of `reduce` where it is set. Values that are not allowed have
/// texts that are refused when they are read.
template <StrategyOptions Options>
OptionMap options_of(const Options& values) {
  OptionMap texts;
  Options::options(
      values, [&]<class Value>(std::string_view name, const Value& value, const RuleFor<Value> auto& rule,
                               std::string_view,
                               const OptionTraits& = {}) { texts[std::string(name)] = rule.text(value); });
  if (values.reduce) texts[std::string(reduce_option)] = OnOff::text(*values.reduce);
  return texts;
}

/// What there is to choose, in the order of the declaration; the defaults are those of the struct.
template <StrategyOptions Options>
std::vector<OptionSpec> specs_of() {
  std::vector<OptionSpec> specs;
  const Options defaults;
  Options::options(
      defaults, [&]<class Value>(std::string_view name, const Value& value, const RuleFor<Value> auto& rule,
                                 std::string_view summary, const OptionTraits& traits = {}) {
        specs.push_back(
            {name, rule.text(value), rule.allowed(), summary, traits.is_length, traits.changes_result});
      });
  return specs;
}

/// The entry of a strategy, of class `Made`, that is constructed from `Options`: its name, its options and
/// how it is made. The other members are left to fill in.
template <std::derived_from<Strategy> Made, StrategyOptions Options>
requires std::constructible_from<Made, const Options&> StrategyEntry entry_of() {
  StrategyEntry entry;
  entry.name = Options::strategy;
  entry.options = specs_of<Options>();
  entry.make = [](const OptionMap& texts) -> std::unique_ptr<Strategy> {
    return std::make_unique<Made>(read_options<Options>(texts));
  };
  return entry;
}

}  // namespace gcs
