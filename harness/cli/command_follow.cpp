/// gcsbench follow: where a figure moves to when values change.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/base/stop_conditions.hpp"
#include "harness/base/summary_line.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/results/follow_io.hpp"
#include "harness/results/result_reader.hpp"

namespace gcs {

namespace {

struct FollowArguments {
  std::string instance;
  std::string from;  ///< empty: the sketch
  std::vector<std::string> to;
  std::string proof = "on";
  std::string out;  ///< empty: no file; "-": standard output
};

/// RESULT or RESULT:n.
struct NamedSolution {
  std::string result;
  std::size_t number = 1;
};

NamedSolution parse_named_solution(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return {text};
  std::size_t number = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, number);
  if (error != std::errc() || rest != end) return {text};
  return {text.substr(0, colon), number};
}

void require_same_elements(const ProblemStatement& a, const ProblemStatement& b, const std::string& result) {
  if (a.dimension == b.dimension && a.points == b.points && a.lines == b.lines && a.planes == b.planes)
    return;
  throw UsageError(fmt::format("--from {}: its elements are not those of the instance", result));
}

Figure solution_of_result(const std::string& from, const ProblemStatement& problem) {
  const NamedSolution named = parse_named_solution(from);
  const StoredResult stored = load_result(named.result);
  require_same_elements(problem, stored.instance.problem, named.result);
  const std::vector<AssessedSolution>& solutions = stored.answer.solutions;
  if (named.number < 1 || named.number > solutions.size())
    throw UsageError(fmt::format("--from {}: there is no solution {}; give a number from 1 to {}",
                                 named.result, named.number, solutions.size()));
  const AssessedSolution& solution = solutions[named.number - 1];
  if (!solution.is_real())
    throw UsageError(fmt::format("--from {}: solution {} is not real", named.result, named.number));
  return solution.placement();
}

/// "id=value,value…" into one list of values an id.
struct Schedule {
  std::string id;
  std::vector<std::string> values;
};

Schedule parse_schedule(const std::string& text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError(fmt::format("--to {}: give ID=VALUE, or ID=VALUE,VALUE… for a polyline", text));
  return {text.substr(0, equals), CLI::detail::split(text.substr(equals + 1), ',')};
}

std::vector<ChangedValues> parse_vertices(const std::vector<std::string>& texts) {
  std::vector<Schedule> schedules;
  for (const std::string& text : texts) {
    schedules.push_back(parse_schedule(text));
    const Schedule& last = schedules.back();
    if (std::ranges::count(schedules, last.id, &Schedule::id) > 1)
      throw UsageError(
          fmt::format("--to {}: given twice; the values of a polyline are separated by commas", last.id));
    if (last.values.size() != schedules.front().values.size())
      throw UsageError(fmt::format("--to {}: {} values, but {} of {}; give as many for every id", last.id,
                                   last.values.size(), schedules.front().values.size(),
                                   schedules.front().id));
  }
  std::vector<ChangedValues> vertices(schedules.empty() ? 1 : schedules.front().values.size());
  for (const Schedule& schedule : schedules)
    for (std::size_t i = 0; i < vertices.size(); ++i)
      vertices[i].push_back({schedule.id, schedule.values[i]});
  return vertices;
}

std::string target_text(const ChangedValues& changes) {
  std::string text;
  for (const ChangedValue& change : changes)
    text += fmt::format("{}{}={}", text.empty() ? "" : ", ", change.id, change.value.text());
  return text.empty() ? "the instance's values" : text;
}

std::string fold_text(const Followed& leg) {
  std::string text = fmt::format("at t in [{:.17g}, {:.17g}] of the way", leg.fold.low, leg.fold.high);
  for (const FoldValue& value : leg.values)
    text += fmt::format("; {} in [{:.17g}, {:.17g}]", value.id, value.low, value.high);
  return text;
}

std::string beyond_text(const Answer& answer) {
  if (answer.status != RunStatus::complete)
    return fmt::format("not known: {}: {}", word(answer.status), answer.reason);
  return fmt::format("{} solutions on S, bent so that it closes", answer.solutions.size());
}

std::string leg_text(const ChangedValues& changes, const Followed& leg) {
  std::string text = summary_line("to", target_text(changes));
  const bool has_end = leg.end == ArcEnd::reached || leg.end == ArcEnd::folds;
  const std::string proof = !has_end                   ? ": " + leg.reason
                            : leg.proven               ? ", proven"
                            : leg.why_unproven.empty() ? ""
                                                       : ", not proven: " + leg.why_unproven;
  text += summary_line("end", fmt::format("{}{}", word(leg.end), proof));
  if (leg.end == ArcEnd::folds) text += summary_line("fold", fold_text(leg));
  if (leg.error) text += summary_line("error", fmt::format("at most {:.1e}", *leg.error));
  if (leg.beyond) text += summary_line("beyond", beyond_text(*leg.beyond));
  return text;
}

std::string summary(const Instance& instance, const FollowedPolyline& polyline) {
  std::string text = fmt::format("{}, follow: {} of {} reached\n", instance.id,
                                 std::ranges::count(polyline.legs, ArcEnd::reached, &Followed::end),
                                 polyline.vertices.size());
  for (std::size_t i = 0; i < polyline.legs.size(); ++i)
    text += leg_text(polyline.vertices[i], polyline.legs[i]);
  return text;
}

ExitCode exit_code(const FollowedPolyline& polyline, bool proves) {
  switch (polyline.legs.back().end) {
    case ArcEnd::stopped:
      return ExitCode::interrupted;
    case ArcEnd::undecided:
    case ArcEnd::unsupported:
      return ExitCode::not_solved;
    case ArcEnd::reached:
    case ArcEnd::folds:
      break;
  }
  return !proves || std::ranges::all_of(polyline.legs, &Followed::proven) ? ExitCode::done
                                                                          : ExitCode::check_failed;
}

ExitCode follow(const FollowArguments& arguments) {
  const Instance instance = load_instance(arguments.instance);
  require_another_file(arguments.out, instance.origin);
  require_another_file(arguments.out, parse_named_solution(arguments.from).result);
  if (arguments.from.empty() && !instance.problem.sketch)
    throw UsageError("the instance has no sketch to begin at; give a solution with --from");
  FollowedPolyline polyline{arguments.from.empty() ? *instance.problem.sketch
                                                   : solution_of_result(arguments.from, instance.problem),
                            parse_vertices(arguments.to),
                            {}};
  std::optional<Output> out;
  if (!arguments.out.empty()) out.emplace(arguments.out);
  FollowSettings settings;
  settings.arc.prove = arguments.proof == "on";
  catch_interrupts();
  const StopWatch watch(std::nullopt);
  polyline.legs = follow_polyline(instance, polyline.from, polyline.vertices, settings, watch.token());
  if (out) out->commit(follow_text(instance, polyline));
  if (arguments.out != "-") std::cout << summary(instance, polyline);
  return exit_code(polyline, settings.arc.prove);
}

void add_options(CLI::App& command, FollowArguments& arguments) {
  add_instance_argument(command, arguments.instance);
  command
      .add_option("--from", arguments.from,
                  "The figure to begin at: the n-th solution of a result, by default the first; without the "
                  "option the "
                  "sketch")
      ->check(place_name())
      ->type_name("RESULT[:n]");
  command
      .add_option("--to", arguments.to,
                  "A constraint's id and its new value, as the instance states it (length, square, degrees, "
                  "cosine); may "
                  "be repeated. Several values, separated by commas, are the vertices of a polyline")
      ->type_name("ID=VALUE[,VALUE...]")
      ->allow_extra_args(false);
  command
      .add_option("--proof", arguments.proof, "on: prove by tubes where the figure moves to; off: track only")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  command
      .add_option("--out", arguments.out,
                  "Write what was found as JSON; - is standard output, which then holds it alone")
      ->check(output_name())
      ->type_name("FILE");
  command.footer(
      "All values go straight, lengths and cosines linearly, from those of the figure to the instance's, "
      "changed\n"
      "as --to says. The figure is reached when it gets there without a fold, and so without a flip. Where "
      "it\n"
      "folds, the value is enclosed, and the solutions beyond are those on S from the figure to the same "
      "values,\n"
      "bent as the instance says so that it closes. Of a polyline each vertex is followed from the last "
      "one.\n"
      "Exit code 1 when there is no proof, 3 when it is not decided where the figure moves to.\n"
      "\nExamples:\n"
      "  gcsbench solve disulfide --strategy rcp --out result.json\n"
      "  gcsbench follow disulfide --from result.json:2 --to a7=3.3 --to a9=16.7\n"
      "  gcsbench follow disulfide --from result.json:2 --to a7=3.3,3.5,3.7 --out moved.json\n");
}

}  // namespace

void add_follow_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<FollowArguments>();
  CLI::App* command = app.add_subcommand("follow", "Say where a figure moves to when values change");
  add_options(*command, *arguments);
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return follow(*arguments); }; });
}

}  // namespace gcs
