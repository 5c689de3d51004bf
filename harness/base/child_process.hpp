#pragma once
/// Runs a command of the user's and holds what it prints.

#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace gcs {

/// How a command ended, and what it printed until then.
struct CommandOutcome {
  enum class End { exited, killed, stopped, too_much_output };
  End end = End::exited;
  int code = 0;  ///< of `exited`: the exit status; of `killed`: the number of the signal
  std::string output;
  std::string errors;  ///< the last few kilobytes of standard error
};

/// Runs `command` by /bin/sh -c with `input` on standard input and `variables` ("NAME=value") added to the
/// environment, and returns when it has closed its standard output and error and has ended. It runs in a
/// process group of its own, in which nothing is left running afterwards. `stop` and more than 64 MiB of
/// output end it: the group is asked to terminate, and killed after a second. Throws std::system_error when
/// the system has no process, pipe or memory left.
CommandOutcome run_command(const std::string& command, std::string_view input,
                           const std::vector<std::string>& variables, const std::stop_token& stop);

}  // namespace gcs
