/// gcsbench complete: what may stand next on the command line.
/// Asked by the completions in harness/cli/shells.

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "harness/cli/commands.hpp"
#include "harness/cli/completion.hpp"

namespace gcs {

void add_complete_command(CLI::App& app, Invocation& invocation) {
  const auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("complete", "What may stand next on the command line, for shells");
  command->group("");  // not listed: shells ask for it, not people
  command->add_option("WORD", *words,
                      "After --: the words after `gcsbench`, the last of them to be completed");
  command->callback([&app, &invocation, words] {
    invocation.action = [&app, words] {
      for (const std::string& word : completions(app, *words)) std::cout << word << '\n';
      return ExitCode::done;
    };
  });
}

}  // namespace gcs
