#pragma once
/// The subcommands of gcsbench, one source file each.

#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gcs {

/// The exit codes of the program; scripts rely on them.
enum class ExitCode {
  done = 0,
  check_failed = 1,  ///< done, but a check did not hold
  bad_input = 2,     ///< usage, or an input that is not valid
  not_solved = 3,    ///< not applicable, gave up or out of time
  interrupted = 130
};

/// A mistake on the command line that the parser cannot see: main prints what() and the subcommand's usage,
/// and exits with bad_input.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What a subcommand shares with main. `quiet`: no progress and no remarks on standard error; errors still
/// show. `action`: set while parsing by the subcommand that was given; main runs it afterwards, where
/// UsageError, InputError, OutputError and OptionError become bad_input.
struct Invocation {
  std::vector<std::string> arguments;  ///< the words of the command line, that of the program first
  bool quiet = false;
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
void add_path_command(CLI::App& app, Invocation& invocation);
void add_reference_command(CLI::App& app, Invocation& invocation);
void add_report_command(CLI::App& app, Invocation& invocation);
void add_manual_command(CLI::App& app, Invocation& invocation);
void add_complete_command(CLI::App& app, Invocation& invocation);
void add_compare_command(CLI::App& app, Invocation& invocation);

}  // namespace gcs
