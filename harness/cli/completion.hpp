#pragma once
/// What may stand on the command line, for shells and messages.

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace gcs {

/// "--out" for every option that has such a name.
std::vector<std::string> option_names(const CLI::App& app);

/// The subcommands that are shown.
std::vector<std::string> command_names(const CLI::App& program);

/// The words that complete the last of `words`, which may be empty; those before it stand already, without
/// the program's name. Names of files are left to the shell.
std::vector<std::string> completions(const CLI::App& program, const std::vector<std::string>& words);

}  // namespace gcs
