/// gcsbench verify: proves the solutions of a stored result anew.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "harness/cli/argument_checks.hpp"
#include "harness/cli/certificates_view.hpp"
#include "harness/cli/commands.hpp"
#include "harness/cli/progress_line.hpp"
#include "harness/cli/standing_view.hpp"
#include "harness/results/verify.hpp"
#include "solvers/certificates/scene_equations.hpp"

namespace gcs {

namespace {

struct VerifyArguments {
  std::string result;
  int threads = 1;
};

std::string summary(const StoredResult& result, const Verification& verification) {
  const std::string verdict = verification.mismatches.empty()
                                  ? "verified"
                                  : fmt::format("{} mismatches", verification.mismatches.size());
  return fmt::format("{}, {}: {}\n", result.instance.id, result.answer.strategy, verdict) +
         certificates_text(verification.proofs, result.answer.solutions.size(),
                           result.answer.claim == Claim::all_complex) +
         standings_text(result.scene.problem(), result.answer);
}

ExitCode verify(const VerifyArguments& arguments, bool quiet) {
  const StoredResult result = load_result(arguments.result);
  if (const auto reason = why_not_certified(result.scene)) {
    std::cerr << "gcsbench: " << *reason << '\n';
    return ExitCode::not_solved;
  }
  const Verification verification = [&] {
    ProgressLine progress(!quiet);
    return verify(result, arguments.threads, &progress);
  }();
  std::cout << summary(result, verification);
  std::cout.flush();
  for (const FailedCheck& mismatch : verification.mismatches)
    std::cerr << "gcsbench: mismatch: " << mismatch.name << ": " << mismatch.what << '\n';
  return verification.mismatches.empty() ? ExitCode::done : ExitCode::check_failed;
}

}  // namespace

void add_verify_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<VerifyArguments>();
  CLI::App* command = app.add_subcommand("verify", "Prove the solutions of a stored result anew");
  command->add_option("RESULT", arguments->result, "A result that solve --out wrote; - is standard input")
      ->required();
  add_threads_option(*command, arguments->threads);
  command->footer(
      "Every solution is certified from the instance and the numbers in the file alone, by Krawczyk's test\n"
      "with the decimal lengths as they are written: it lies within its error bound of a proven solution, "
      "no\n"
      "two are the same class, and every count equals what the list gives. Exit code 1 when one does not.\n"
      "\nExample:\n"
      "  gcsbench solve disulfide --strategy rcp --out result.json\n"
      "  gcsbench verify result.json\n");
  command->callback([&invocation, arguments] {
    invocation.action = [&invocation, arguments] { return verify(*arguments, invocation.quiet); };
  });
}

}  // namespace gcs
