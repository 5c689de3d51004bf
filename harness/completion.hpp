#pragma once
/// What may stand next on the command line, for shells.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gcs {

/// The words that complete the last of `words`, which may be empty; those before it stand already, without
/// the program's name. Names of files are left to the shell.
std::vector<std::string> completions(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace gcs
