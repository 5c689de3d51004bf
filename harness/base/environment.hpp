#pragma once
/// Where and with what a result was computed.

#include <string>

namespace gcs {

struct Environment {
  std::string cpu;       ///< model name, "unknown" where the system does not say
  std::string compiler;  ///< name and version
  std::string flags;     ///< those that change the generated code
  /// Hash of the source, "unknown" outside git;
  /// where it was edited, "+dirty-" and a hash of the edit are appended.
  std::string commit;
  int threads = 1;                ///< threads that the strategy was allowed
  std::string instructions = {};  ///< the widest vector instructions there are: "AVX2"
};

/// The environment of this process; `threads` is passed on.
Environment capture_environment(int threads);

/// The version of the program, "1.2.3".
std::string program_version();

}  // namespace gcs
