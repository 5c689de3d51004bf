#pragma once
/// An external program as a strategy: `--strategy exec:COMMAND`.

#include <optional>
#include <string>
#include <string_view>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// The command of "exec:COMMAND"; nothing for any other name of a strategy.
std::optional<std::string> exec_command(std::string_view strategy);

/// Runs COMMAND by /bin/sh -c for every solve. It reads the scene as gcsbench-instance/1 on standard input
/// (see problem_text) and writes gcsbench-result/1 to standard output, of which these members are read:
///   solutions   an array of {"points": …, "lines": …, "multiplicity": …} in any frame, as in a result
///   claim       as in a result; default: some real
///   status      as in a result; default: complete
///   reason      why it is not complete
///   path        as in a result, for the claim "on path"
/// GCSBENCH_SEED, GCSBENCH_THREADS and GCSBENCH_PROGRAM, the file of the program that runs it, are in its environment. What it claims is its own claim: its solutions
/// are assessed like those of any strategy. An exit status other than 0, and output that cannot be read, make
/// it give up, with the cause and the last line of standard error.
/// `name` must outlive the entry. Throws UsageError when there is no command in it.
StrategyEntry exec_entry(std::string_view name);

/// "exec:COMMAND" in short, for tables: without the folders of the program, on one line, 40 characters at
/// most. Any other name as it is.
std::string short_name(std::string_view strategy);

}  // namespace gcs
