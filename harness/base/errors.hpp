#pragma once
/// How the program ends, and what ends it early. What is wrong with an input is an InputError
/// (solvers/reading/json_document.hpp), with an option an OptionError.

#include "solvers/running/errors.hpp"

namespace gcs {

/// The exit codes of the program; scripts rely on them.
enum class ExitCode {
  done = 0,
  check_failed = 1,     ///< done, but a check did not hold
  bad_input = 2,        ///< usage, or an input that is not valid
  not_solved = 3,       ///< not applicable, gave up or out of time
  internal_error = 70,  ///< the program's own fault (EX_SOFTWARE of sysexits.h)
  interrupted = 130
};

/// A mistake on the command line that the parser cannot see: main prints what() and the subcommand's usage,
/// and exits with bad_input.
class UsageError : public UserError {
 public:
  using UserError::UserError;
};

/// A place that cannot be written. what(): "FILE: cannot be written: cause".
class OutputError : public UserError {
 public:
  using UserError::UserError;
};

}  // namespace gcs
