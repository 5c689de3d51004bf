/// gcsbench reference: a stored result's solutions, proven, with many digits.

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "harness/base/atomic_file.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/cli/progress_line.hpp"
#include "harness/results/reference_io.hpp"
#include "solvers/certificates/scene_equations.hpp"

namespace gcs {

namespace {

struct ReferenceArguments {
  std::string result;
  std::string out;
  ReferenceSettings settings;
};

ExitCode write_reference(const ReferenceArguments& arguments, bool quiet) {
  require_another_file(arguments.out, arguments.result);
  const StoredResult result = load_result(arguments.result);
  if (const auto reason = why_not_certified(result.scene)) {
    std::cerr << "gcsbench: " << *reason << '\n';
    return ExitCode::not_solved;
  }
  Output out(arguments.out);
  const std::string text = [&] {
    ProgressLine progress(!quiet);
    return reference_text(result, arguments.settings, progress);
  }();
  out.commit(text);
  return ExitCode::done;
}

}  // namespace

void add_reference_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<ReferenceArguments>();
  CLI::App* command = app.add_subcommand("reference", "Write a result's solutions, proven, with many digits");
  command->add_option("RESULT", arguments->result, "A result that solve --out wrote; - is standard input")
      ->required();
  command->add_option("--out", arguments->out, "The file to write; - is standard output")
      ->check(output_name())
      ->type_name("FILE")
      ->required();
  command->add_option("--digits", arguments->settings.digits, "Significant digits of every number")
      ->transform(whole_number(17, 250))
      ->type_name("N")
      ->capture_default_str();
  command->add_flag("--only-real", arguments->settings.only_real, "Leave the complex solutions out");
  add_threads_option(*command, arguments->settings.threads);
  command->footer(
      "The result is verified first, as `gcsbench verify` does it; one that does not verify is refused.\n"
      "\nExample:\n"
      "  gcsbench solve octahedron --strategy cayley-menger --out result.json\n"
      "  gcsbench reference result.json --out octahedron.json\n");
  command->callback([&invocation, arguments] {
    invocation.action = [&invocation, arguments] { return write_reference(*arguments, invocation.quiet); };
  });
}

}  // namespace gcs
