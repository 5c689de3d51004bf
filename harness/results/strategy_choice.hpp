#pragma once
/// From the words of the command line to a strategy and its options.

#include <span>
#include <string>
#include <string_view>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// The strategy of that name. Throws UsageError with the nearest name when there is none.
const StrategyEntry& find_strategy(std::string_view name);

/// The strategy of that name, or the external program of "exec:COMMAND", whose entry refers to `name`.
/// Throws UsageError likewise.
StrategyEntry find_strategy_or_program(const std::string& name);
StrategyEntry find_strategy_or_program(std::string&& name) = delete;

/// The options of `settings`, each "option=value". Throws UsageError for another shape, a name that the
/// strategy does not have (with the nearest one), or a name given twice, and OptionError for a value that the
/// strategy does not take.
OptionMap parse_settings(const StrategyEntry& entry, std::span<const std::string> settings);

}  // namespace gcs
