/// The program gcsbench: parses the command line, runs one subcommand, maps every outcome to an exit code.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/environment.hpp"
#include "harness/cli/commands.hpp"
#include "harness/cli/completion.hpp"
#include "harness/ranks/rank_crew.hpp"
#include "harness/ranks/ranks.hpp"
#include "harness/tables/table_run.hpp"
#include "solvers/certificates/certificate_member.hpp"
#include "solvers/homotopies/leg_member.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/reading/json_document.hpp"
#include "solvers/reading/nearest_name.hpp"

namespace {

using gcs::ExitCode;

void add_commands(CLI::App& app, gcs::Invocation& invocation) {
  app.add_flag("--quiet", invocation.quiet, "No progress and no remarks on standard error");
  app.set_version_flag("--version", std::string("gcsbench ") + gcs::program_version());
  app.require_subcommand(0, 1);  // that there is one is checked afterwards, with a better message
  app.fallthrough();             // inherited by the subcommands: `gcsbench solve … --quiet`
  gcs::add_list_command(app, invocation);
  gcs::add_describe_command(app, invocation);
  gcs::add_count_command(app, invocation);
  gcs::add_solve_command(app, invocation);
  gcs::add_tables_command(app, invocation);
  gcs::add_precision_command(app, invocation);
  gcs::add_stability_command(app, invocation);
  gcs::add_verify_command(app, invocation);
  gcs::add_follow_command(app, invocation);
  gcs::add_path_command(app, invocation);
  gcs::add_reference_command(app, invocation);
  gcs::add_convert_command(app, invocation);
  gcs::add_report_command(app, invocation);
  gcs::add_compare_command(app, invocation);
  gcs::add_manual_command(app, invocation);
  gcs::add_complete_command(app, invocation);
  app.footer(
      "Exit codes:\n"
      "  0    done\n"
      "  1    done, but a check did not hold: a count, a certificate, a comparison\n"
      "  2    wrong usage, or an input that is not valid; nothing was changed\n"
      "  3    the strategy cannot do this, gave up or ran out of time, or there are infinitely many\n"
      "       solutions; what was found is kept\n"
      "  70   an internal error: a fault of this program\n"
      "  130  interrupted; what was found is kept\n"
      "\nExamples:\n"
      "  gcsbench list\n"
      "  gcsbench describe octahedron\n"
      "  gcsbench solve octahedron --strategy cayley-menger --certify\n"
      "  gcsbench tables table1 --out results/runs/today\n");
}

ExitCode fail(const std::string& message) {
  std::cout.flush();
  std::cerr << "gcsbench: " << message << '\n';
  return ExitCode::bad_input;
}

/// The usage of the subcommand that was named, or of the program.
std::string usage(const CLI::App& app) {
  const auto named = app.get_subcommands();
  const CLI::App* command = named.empty() ? &app : named.back();
  const std::string name = named.empty() ? "gcsbench" : "gcsbench " + command->get_name();
  return CLI::Formatter().make_usage(command, name) + "Run `" + name + " --help` for more.";
}

/// What is wrong with a word that looks like an option and is none of the command's, if there is one.
std::optional<std::string> unknown_option(const CLI::App& app) {
  std::vector<std::string> names = gcs::option_names(app);
  for (const CLI::App* command : app.get_subcommands())
    for (std::string& name : gcs::option_names(*command)) names.push_back(std::move(name));
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with('-') || word == "-" || word == "--") continue;
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("there is no option {}; did you mean {}?", name, gcs::nearest_name(name, names));
  }
  return std::nullopt;
}

/// What is wrong when no command was recognised.
std::string no_command(const CLI::App& app) {
  const auto names = gcs::command_names(app);
  const auto words = app.remaining();
  if (words.empty()) return "expected a command: " + gcs::quoted_list(names);
  return fmt::format("there is no command '{}'; did you mean '{}'?", words.front(),
                     gcs::nearest_name(words.front(), names));
}

/// The library's own exit codes are not ours: help and version are done, everything else is bad input.
ExitCode after_parse_error(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) {
    app.exit(error);
    return ExitCode::done;
  }
  const auto is = [&](CLI::ExitCodes code) { return error.get_exit_code() == static_cast<int>(code); };
  std::optional<std::string> message;
  if (is(CLI::ExitCodes::ExtrasError) || is(CLI::ExitCodes::RequiredError)) message = unknown_option(app);
  if (!message && is(CLI::ExitCodes::ExtrasError) && app.get_subcommands().empty()) message = no_command(app);
  return fail(message.value_or(error.what()) + "\n" + usage(app));
}

ExitCode parse_and_run(int argc, char** argv, gcs::Crew* crew, int ranks_here) {
  CLI::App app("Benchmarks for geometric constraint solving", "gcsbench");
  gcs::Invocation invocation;
  invocation.arguments.assign(argv, argv + argc);
  invocation.crew = crew;
  invocation.ranks_here = ranks_here;
  try {
    add_commands(app, invocation);
    app.parse(argc, argv);
    if (!invocation.action) throw gcs::UsageError(no_command(app));
    return invocation.action();
  } catch (const CLI::ParseError& error) {
    return after_parse_error(app, error);
  } catch (const gcs::UsageError& error) {
    return fail(error.what() + std::string("\n") + usage(app));
  } catch (const gcs::UserError& error) {
    return fail(error.what());
  } catch (const std::exception& error) {
    fail(fmt::format("internal error: {}", error.what()));
    return ExitCode::internal_error;
  }
}

/// Of what commands hand out to other ranks.
std::unique_ptr<gcs::ItemWork> begin_task(const std::string& task) {
  if (auto cells = gcs::begin_cells(task)) return cells;
  if (auto certificates = gcs::begin_certificates(task)) return certificates;
  return gcs::begin_legs(task);
}

/// The first rank runs the program, the others what it hands out.
ExitCode run_ranks(int argc, char** argv, const gcs::MessagePassing& ranks) {
  const std::string build = gcs::build_of_program();
  if (ranks.rank > 0) {
    gcs::serve(ranks, build, begin_task);
    return ExitCode::done;
  }
  gcs::RankCrew crew(ranks, build);
  return crew.misfit().empty() ? parse_and_run(argc, argv, &crew, ranks.on_this_machine)
                               : fail(crew.misfit());
}

ExitCode run(int argc, char** argv) {
  try {
    const gcs::MessagePassing* ranks = gcs::start_ranks();
    if (ranks == nullptr) return parse_and_run(argc, argv, nullptr, 1);
    const ExitCode code = run_ranks(argc, argv, *ranks);
    ranks->finish();
    return code;
  } catch (const gcs::UserError& error) {
    return *error.what() == '\0' ? ExitCode::bad_input : fail(error.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  // A file that outgrows the limit is reported as any other that cannot be written.
  std::signal(SIGXFSZ, SIG_IGN);
  ExitCode code = run(argc, argv);
  if (!std::cout.flush()) code = fail("standard output cannot be written");
  return static_cast<int>(code);
}
