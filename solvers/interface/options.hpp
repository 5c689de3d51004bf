#pragma once
/// Typed reading of option values; every message names the option, the value and what would be right.

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// The value as a finite number in [low, high]. Throws OptionError.
double number_option(const OptionMap& options, std::string_view name, double low, double high);
/// The value as a whole number in [low, high]. Throws OptionError.
std::int64_t integer_option(const OptionMap& options, std::string_view name, std::int64_t low,
                            std::int64_t high);
/// The index of the value among the words of `allowed`, which are separated by '|'. Throws OptionError.
int choice_option(const OptionMap& options, std::string_view name, std::string_view allowed);

/// The name of a file, or nothing for the word "none". Throws OptionError for an empty name.
std::optional<std::string> file_option(const OptionMap& options, std::string_view name);

}  // namespace gcs
