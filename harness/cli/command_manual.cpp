/// gcsbench manual: the manual page.

#include <CLI/CLI.hpp>
#include <iostream>

#include "harness/base/environment.hpp"
#include "harness/cli/commands.hpp"
#include "harness/cli/manual.hpp"

namespace gcs {

void add_manual_command(CLI::App& app, Invocation& invocation) {
  CLI::App* command = app.add_subcommand("manual", "Write this help as a manual page");
  command->footer("\nExample:\n  gcsbench manual | man -l -\n");
  command->callback([&app, &invocation] {
    invocation.action = [&app] {
      std::cout << manual_page(app, program_version());
      return ExitCode::done;
    };
  });
}

}  // namespace gcs
