#include "harness/results/exec_strategy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include "harness/base/child_process.hpp"
#include "harness/base/errors.hpp"
#include "harness/instances/problem_text.hpp"
#include "harness/results/result_reader.hpp"
#include "solvers/elements/placement.hpp"
#include "solvers/reading/utf8_text.hpp"

namespace gcs {
namespace {

constexpr std::string_view prefix = "exec:";

/// Of a message or a name, in characters of ASCII.
constexpr std::size_t longest_message = 200;
constexpr std::size_t longest_name = 40;

/// The text on one line, cut off before a character where it is too long.
std::string in_short(std::string text, std::size_t longest) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == 0x7f; }, ' ');
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end) + "…";
}

/// The last line that is not empty, in ASCII.
std::string last_line(const std::string& text) {
  constexpr const char* blank = " \t\r\n";
  const auto end = text.find_last_not_of(blank);
  if (end == std::string::npos) return "";
  const auto newline = text.find_last_of('\n', end);
  const std::size_t start = newline == std::string::npos ? 0 : newline + 1;
  std::string line = text.substr(start, end + 1 - start);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c > 0x7e; }, '?');
  return line;
}

/// Why the program has no answer that could be read; nothing when it ended well.
std::optional<std::string> failure(const CommandOutcome& outcome) {
  switch (outcome.end) {
    case CommandOutcome::End::exited:
      if (outcome.code == 0) return std::nullopt;
      return fmt::format("the program ended with exit status {}", outcome.code);
    case CommandOutcome::End::killed:
      return fmt::format("the program was ended by signal {}", outcome.code);
    case CommandOutcome::End::too_much_output:
      return "the program wrote more than 64 MiB and was ended";
    case CommandOutcome::End::stopped:
      return "stopped on request";
  }
  return std::nullopt;
}

/// Every line and plane with a direction of length 1.
Candidate candidate_of(const AssessedSolution& solution) {
  Placement at = placement_of(solution.figure);
  for (ComplexPlane& plane : at.planes) plane = normalised(plane);
  const std::vector<bool> turned(at.planes.size(), false);
  return {figure_of(at, solution.figure.is_real(), turned), solution.multiplicity};
}

/// The path that a program says to be closed. A result has one representative of each class, and S meets a
/// class in one point and in its mirror image, each once: the second crossing of a class is of the image.
void take_path(const Scene& scene, const std::vector<AssessedCrossing>& crossings, SolveReport& report) {
  PathRecord& path = report.paths.emplace_back();
  path.end = PathRecord::End::closed;
  std::set<int> met;
  for (const AssessedCrossing& crossing : crossings) {
    int candidate = crossing.solution.value_or(-1);
    if (candidate >= 0 && !met.insert(candidate).second) {
      Candidate image = report.candidates[static_cast<std::size_t>(candidate)];
      image.figure.points.row(scene.dimension() - 1) *= -1;
      candidate = static_cast<int>(report.candidates.size());
      report.candidates.push_back(std::move(image));
    }
    path.crossings.push_back({candidate, crossing.direction});
  }
}

/// What the program says of its answer as a whole.
void take_status(const Answer& answer, SolveReport& report) {
  const std::string reason = in_short(answer.reason, longest_message);
  const std::string because = reason.empty() ? "" : ": " + reason;
  if (answer.status == RunStatus::complete) {
    report.status = SolveStatus::complete;
  } else if (answer.status == RunStatus::partial) {
    report.status = SolveStatus::partial;
    report.reason = "the program says that its answer is partial" + because;
  } else {
    report.status = SolveStatus::gave_up;
    report.reason = fmt::format("the program says \"{}\"{}", word(answer.status), because);
  }
}

SolveReport report_of(const Scene& scene, const Answer& answer) {
  SolveReport report;
  report.claim = answer.claim.value_or(Claim::some_real);
  for (const AssessedSolution& solution : answer.solutions)
    report.candidates.push_back(candidate_of(solution));
  if (report.claim == Claim::on_path || report.claim == Claim::on_path_of_core)
    take_path(scene, answer.crossings, report);
  take_status(answer, report);
  return report;
}

/// Its file; empty where the system does not say.
std::string this_program() {
  std::error_code unknown;
  return std::filesystem::read_symlink("/proc/self/exe", unknown).string();
}

class ExecStrategy final : public Strategy {
 public:
  explicit ExecStrategy(std::string command) : command_(std::move(command)) {}

  /// The program alone can tell.
  std::optional<std::string> why_unsupported(const SolveRequest&) const override { return std::nullopt; }

  SolveReport solve(const SolveRequest& request) override {
    if (request.monitor != nullptr) request.monitor->progress("external program", -1);
    const CommandOutcome outcome = run_command(
        command_, problem_text(request.scene),
        {fmt::format("GCSBENCH_SEED={}", request.seed), fmt::format("GCSBENCH_THREADS={}", request.threads),
         "GCSBENCH_PROGRAM=" + this_program()},
        request.stop);
    SolveReport report;
    try {
      const auto reason = failure(outcome);
      if (!reason)
        return report_of(request.scene, parse_answer(outcome.output, request.scene, "the program's output"));
      report.reason = *reason;
    } catch (const InputError& error) {
      report.reason = error.what();
    }
    if (outcome.end == CommandOutcome::End::stopped) report.status = SolveStatus::stopped;
    if (const std::string said = last_line(outcome.errors); !said.empty())
      report.reason += fmt::format(" (it said: {})", in_short(said, longest_message));
    return report;
  }

 private:
  std::string command_;
};

}  // namespace

std::optional<std::string> exec_command(std::string_view strategy) {
  if (!strategy.starts_with(prefix)) return std::nullopt;
  return std::string(strategy.substr(prefix.size()));
}

StrategyEntry exec_entry(std::string_view name) {
  const std::string command = exec_command(name).value_or("");
  if (command.find_first_not_of(" \t\r\n") == std::string::npos)
    throw UsageError("exec: needs a command: --strategy 'exec:./my-solver --fast'");
  if (!is_utf8(command)) throw UsageError("exec: the command is no text in UTF-8");
  StrategyEntry entry;
  entry.name = name;
  entry.summary = "an external program";
  entry.make = [command](const OptionMap&) -> std::unique_ptr<Strategy> {
    return std::make_unique<ExecStrategy>(command);
  };
  return entry;
}

std::string short_name(std::string_view strategy) {
  const auto command = exec_command(strategy);
  if (!command) return std::string(strategy);
  const auto program_end = std::min(command->find(' '), command->size());
  const auto folder_end = command->rfind('/', program_end);
  return std::string(prefix) +
         in_short(command->substr(folder_end == std::string::npos ? 0 : folder_end + 1), longest_name);
}

}  // namespace gcs
