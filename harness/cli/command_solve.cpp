/// gcsbench solve: one strategy on one instance.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/environment.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/cli/progress_line.hpp"
#include "harness/cli/solve_summary.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/results/certificate_io.hpp"
#include "harness/results/result_io.hpp"
#include "harness/results/strategy_choice.hpp"
#include "harness/solving/file_journal.hpp"
#include "harness/solving/solve_identity.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/reading/nearest_name.hpp"

namespace gcs {

namespace {

struct SolveArguments {
  std::string instance;
  std::string strategy;
  std::vector<std::string> settings;
  std::string out;          ///< empty: no file; "-": standard output
  std::string solutions;    ///< "real" or "all"; empty: all
  std::string resume;       ///< the journal's file; empty: none
  std::string certificate;  ///< empty: none
  RunLimits limits;
};

void complain(const std::string& message) {
  std::cout.flush();
  std::cerr << "gcsbench: " << message << '\n';
}

void complain_about(const SolveRun& run) {
  for (const FailedCheck& check : run.failed_checks)
    complain(fmt::format("check failed: {}: {}", check.name, check.what));
  if (run.status != RunStatus::complete)
    complain(fmt::format("{}: {}: {}", run.strategy, word(run.status), run.reason));
}

ExitCode exit_code(const SolveRun& run) {
  if (run.has_failed) return ExitCode::internal_error;
  switch (run.status) {
    case RunStatus::interrupted:
      return ExitCode::interrupted;
    case RunStatus::unsupported:
    case RunStatus::gave_up:
    case RunStatus::timed_out:
    case RunStatus::infinite:
    case RunStatus::stopped:
      return ExitCode::not_solved;
    case RunStatus::complete:
    case RunStatus::partial:
      break;
  }
  return run.failed_checks.empty() ? ExitCode::done : ExitCode::check_failed;
}

/// Standard output gets the JSON when it was asked for there, else the summary of what was run.
void print_answer(const SolveArguments& arguments, const Instance& instance, const SolveRun& run,
                  std::optional<Output>& out) {
  if (out) {
    write_result(
        instance, run, capture_environment(run.threads), [&](std::string_view piece) { out->write(piece); },
        form_of(arguments.out));
    out->commit();
  }
  if (arguments.out == "-") return;
  if (run.status != RunStatus::unsupported) std::cout << solve_summary(instance, run);
}

/// The file that --certificate names, if any.
std::optional<Output> open_certificate(const SolveArguments& arguments, const Instance& instance) {
  if (arguments.certificate.empty()) return std::nullopt;
  for (const std::string& used : {instance.origin, arguments.resume, arguments.out})
    require_another_file(arguments.certificate, used, "--certificate");
  require_certifiable(instance);
  return std::optional<Output>(std::in_place, arguments.certificate);
}

void keep_certificate(const Instance& instance, const Scene& scene, const SolveRun& run,
                      Output& certificate) {
  const std::uint64_t proven = run.proofs ? run.proofs->with_multiplicities() : 0;
  if (proven == 0) return complain("nothing is proven, and no certificate is written");
  const std::uint64_t kept =
      write_certificate(instance, scene, run, [&](std::string_view piece) { certificate.write(piece); });
  certificate.commit();
  if (kept < proven)
    complain(fmt::format("the certificate has {} of {} proven solutions: the others take too many digits",
                         kept, proven));
}

std::string strategies_with_a_journal() {
  std::vector<std::string> names;
  for (const StrategyEntry& entry : all_strategies())
    if (entry.keeps_journal) names.emplace_back(entry.name);
  return quoted_list(names);
}

/// The journal that --resume names, if any.
std::unique_ptr<FileJournal> open_journal(const SolveArguments& arguments, const StrategyEntry& entry,
                                          const OptionMap& options, const Instance& instance) {
  if (arguments.resume.empty()) return nullptr;
  if (!entry.keeps_journal)
    throw UsageError(
        fmt::format("--resume: strategy {} keeps no journal to go on from; leave it out (with a "
                    "journal: {})",
                    entry.name, strategies_with_a_journal()));
  return std::make_unique<FileJournal>(
      arguments.resume, solve_identity(instance, entry, complete_options(entry, options),
                                       arguments.limits.seed, capture_environment(arguments.limits.threads)));
}

ExitCode solve(const SolveArguments& arguments, bool quiet, Crew* crew) {
  const StrategyEntry entry = find_strategy_or_program(arguments.strategy);
  const OptionMap options = parse_settings(entry, arguments.settings);
  const Instance instance = load_instance(arguments.instance);
  require_another_file(arguments.out, instance.origin);
  require_another_file(arguments.out, arguments.resume);
  std::optional<Output> out;
  if (!arguments.out.empty()) out.emplace(arguments.out);
  std::optional<Output> certificate = open_certificate(arguments, instance);
  const std::unique_ptr<FileJournal> journal = open_journal(arguments, entry, options, instance);

  catch_interrupts();
  RunLimits limits = arguments.limits;
  limits.only_real = arguments.solutions == "real";
  limits.certify = limits.certify || certificate;
  const Scene scene = instance;
  SolveRun run = [&] {
    ProgressLine progress(!quiet);
    return run_strategy(entry, options, scene, limits, {&progress, journal.get(), crew});
  }();
  if (journal) run.timing.recalled_steps = journal->recalled();
  print_answer(arguments, instance, run, out);
  if (certificate) keep_certificate(instance, scene, run, *certificate);
  complain_about(run);
  return exit_code(run);
}

/// The options of every strategy, for --help.
std::string settings_help() {
  std::string text = "Options for --set:\n";
  for (const StrategyEntry& entry : all_strategies()) {
    text += fmt::format("  {}: {}\n", entry.name, entry.summary);
    for (const OptionSpec& option : entry.options)
      text += fmt::format("    {}={}  ({}) {}\n", option.name, option.default_value, option.allowed,
                          option.summary);
  }
  return text +
         "\nExamples:\n"
         "  gcsbench solve disulfide --strategy rcp\n"
         "  gcsbench solve ./my.json --strategy full-space --time-limit 60 --out result.json\n"
         "  gcsbench solve octahedron --strategy rcp --out - | python3 -m json.tool\n"
         "  gcsbench solve icosahedron --strategy monodromy --resume icosahedron.journal\n"
         "  gcsbench solve k33 --strategy exec:scripts/phcpack-solve\n"
         "\nThe one with --resume may be stopped in any way and started again with the same words: nothing "
         "that was\n"
         "done is computed again. Threads, instruction set, --time-limit and --out may change; a journal of\n"
         "anything else is refused.\n"
         "\nexec:COMMAND is run by /bin/sh -c: it reads the instance as gcsbench-instance/1 on standard "
         "input and\n"
         "writes {\"solutions\": [{\"points\": {...}}]} or any other gcsbench-result/1 to standard output\n"
         "(solvers/strategies/README.md).\n";
}

void add_options(CLI::App& command, SolveArguments& arguments, int ranks_here) {
  add_instance_argument(command, arguments.instance);
  command
      .add_option(
          "--strategy", arguments.strategy,
          "Name of the strategy (see `gcsbench list strategies`), or exec:COMMAND, an external program")
      ->type_name("NAME")
      ->required();
  command.add_option("--set", arguments.settings, "An option of the strategy; may be repeated")
      ->type_name("OPTION=VALUE")
      ->allow_extra_args(false);
  command
      .add_option("--out", arguments.out,
                  "Write the result as JSON, or as CBOR where the name ends in .cbor; - is standard output, "
                  "which then holds the JSON alone")
      ->check(output_name())
      ->type_name("FILE");
  command.add_option("--seed", arguments.limits.seed, "Seed of everything random")
      ->transform(whole_number(0, std::numeric_limits<std::uint64_t>::max()))
      ->type_name("N")
      ->capture_default_str();
  add_threads_option(command, arguments.limits.threads, ranks_here);
  command.add_option("--time-limit", arguments.limits.time_limit_s, "Time after which the solve is stopped")
      ->type_name("SECONDS")
      ->check(number_between(std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max(),
                             "a number of seconds > 0"));
  command.add_option("--max-solutions", arguments.limits.max_solutions, "List at most so many solutions")
      ->transform(whole_number(1, std::numeric_limits<std::size_t>::max()))
      ->type_name("N");
  command
      .add_option("--solutions", arguments.solutions,
                  "Which solutions to list: real, or all that the strategy finds, which is the default")
      ->check(CLI::IsMember({"real", "all"}));
  command.add_flag("--certify", arguments.limits.certify,
                   "Prove that every solution exists, is real or not as listed, and a class of its own");
  command
      .add_option(
          "--certificate", arguments.certificate,
          "--certify, and write the proofs to FILE for scripts/check-certificate, a checker of its own")
      ->check(place_name())
      ->type_name("FILE");
  command
      .add_option("--resume", arguments.resume,
                  "Keep a journal in FILE; when it is there, go on where it ends, with the same result")
      ->check(place_name())
      ->type_name("FILE");
  command.footer(settings_help);
}

}  // namespace

void add_solve_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<SolveArguments>();
  CLI::App* command = app.add_subcommand("solve", "Solve one instance with one strategy");
  add_options(*command, *arguments, invocation.ranks_here);
  command->callback([&invocation, arguments] {
    invocation.action = [&invocation, arguments] {
      arguments->limits.threads *= invocation.ranks_here;
      return solve(*arguments, invocation.quiet, invocation.crew);
    };
  });
}

}  // namespace gcs
