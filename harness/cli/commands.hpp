#pragma once
/// The subcommands of gcsbench, one source file each.

#include <functional>
#include <string>
#include <vector>

#include "harness/base/errors.hpp"
#include "solvers/running/crew.hpp"

namespace CLI {
class App;
}

namespace gcs {

/// What a subcommand shares with main. `quiet`: no progress and no remarks on standard error; errors still
/// show. `action`: set while parsing by the subcommand that was given; main runs it afterwards, where
/// UsageError, InputError, OutputError and OptionError become bad_input.
struct Invocation {
  std::vector<std::string> arguments;  ///< the words of the command line, that of the program first
  bool quiet = false;
  Crew* crew = nullptr;  ///< the other ranks; null where the program was started alone
  int ranks_here = 1;    ///< on this machine
  std::function<ExitCode()> action;
};

/// Each function adds its subcommand to `app`; `invocation` must outlive the parsing and the action.
void add_list_command(CLI::App& app, Invocation& invocation);
void add_describe_command(CLI::App& app, Invocation& invocation);
void add_count_command(CLI::App& app, Invocation& invocation);
void add_solve_command(CLI::App& app, Invocation& invocation);
void add_tables_command(CLI::App& app, Invocation& invocation);
void add_precision_command(CLI::App& app, Invocation& invocation);
void add_stability_command(CLI::App& app, Invocation& invocation);
void add_verify_command(CLI::App& app, Invocation& invocation);
void add_follow_command(CLI::App& app, Invocation& invocation);
void add_path_command(CLI::App& app, Invocation& invocation);
void add_reference_command(CLI::App& app, Invocation& invocation);
void add_convert_command(CLI::App& app, Invocation& invocation);
void add_report_command(CLI::App& app, Invocation& invocation);
void add_manual_command(CLI::App& app, Invocation& invocation);
void add_complete_command(CLI::App& app, Invocation& invocation);
void add_compare_command(CLI::App& app, Invocation& invocation);

}  // namespace gcs
