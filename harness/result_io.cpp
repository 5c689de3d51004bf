#include "harness/result_io.hpp"

#include <utility>

#include "harness/json_build.hpp"

namespace gcs {

namespace {

JsonValue vector_value(const Eigen::Vector3d& vector, int dimension) {
  std::vector<JsonValue> coordinates;
  for (int i = 0; i < dimension; ++i) coordinates.push_back(json_number(vector[i]));
  return json_array(std::move(coordinates));
}

JsonValue points_value(const Problem& problem, const Figure& figure) {
  JsonMembers points;
  for (std::size_t i = 0; i < problem.points.size(); ++i)
    points.emplace_back(problem.points[i],
                        vector_value(figure.points.col(static_cast<Eigen::Index>(i)), problem.dimension));
  return json_object(std::move(points));
}

JsonValue lines_value(const Problem& problem, const Figure& figure) {
  JsonMembers lines;
  for (std::size_t i = 0; i < problem.lines.size(); ++i)
    lines.emplace_back(problem.lines[i],
                       json_object({{"point", vector_value(figure.lines[i].point, 3)},
                                    {"direction", vector_value(figure.lines[i].direction, 3)}}));
  return json_object(std::move(lines));
}

JsonValue solution_value(const Problem& problem, const AssessedSolution& solution) {
  return json_object({{"points", points_value(problem, solution.figure)},
                      {"lines", lines_value(problem, solution.figure)},
                      {"real", json_boolean(solution.real)},
                      {"multiplicity", json_number(solution.multiplicity)},
                      {"residual", json_number(solution.residual)},
                      {"condition", json_number(solution.condition)},
                      {"error_bound", json_or_null(solution.error_bound, json_number)},
                      {"certified", json_boolean(solution.certified)}});
}

JsonValue solutions_value(const Problem& problem, const std::vector<AssessedSolution>& solutions) {
  std::vector<JsonValue> values;
  for (const AssessedSolution& solution : solutions) values.push_back(solution_value(problem, solution));
  return json_array(std::move(values));
}

JsonValue counts_value(const Counts& counts) {
  const auto value = [](const std::optional<std::uint64_t>& count) {
    return json_or_null(count, json_count);
  };
  return json_object({{"real_up_to_reflection", value(counts.real_up_to_reflection)},
                      {"complex_up_to_reflection", value(counts.complex_up_to_reflection)},
                      {"generic", value(counts.generic)},
                      {"on_path", value(counts.on_path)},
                      {"paths", value(counts.paths)},
                      {"at_infinity", value(counts.at_infinity)},
                      {"singular", value(counts.singular)},
                      {"failed_paths", value(counts.failed_paths)},
                      {"certified", value(counts.certified)}});
}

/// Null for a strategy that follows no path in the lengths.
JsonValue path_value(const SolveRun& run) {
  if (run.claim != Claim::on_path && run.claim != Claim::on_path_of_core) return json_null();
  std::vector<JsonValue> crossings;
  for (const AssessedCrossing& crossing : run.assessment.crossings)
    crossings.push_back(json_object({{"solution", json_or_null(crossing.solution, json_number)},
                                     {"direction", json_number(crossing.direction)}}));
  return json_array(std::move(crossings));
}

JsonValue statistics_value(const WorkCounters& work) {
  const auto count = [](std::int64_t value) { return json_count(static_cast<std::uint64_t>(value)); };
  return json_object({{"iterations", count(work.iterations)},
                      {"rejected_steps", count(work.rejected_steps)},
                      {"smallest_step", json_or_null(work.smallest_step, json_number)},
                      {"plan_changes", count(work.plan_changes)},
                      {"mean_driving_parameters", json_or_null(work.mean_driving_parameters, json_number)},
                      {"max_driving_parameters", json_or_null(work.max_driving_parameters, json_number)},
                      {"newton_iterations", count(work.newton_iterations)},
                      {"evaluations", count(work.evaluations)},
                      {"partial_evaluations", count(work.partial_evaluations)},
                      {"jacobians", count(work.jacobians)},
                      {"factorisations", count(work.factorisations)}});
}

JsonValue options_value(const OptionMap& options) {
  JsonMembers members;
  for (const auto& [name, value] : options) members.emplace_back(name, json_text(value));
  return json_object(std::move(members));
}

JsonValue failed_checks_value(const std::vector<FailedCheck>& checks) {
  std::vector<JsonValue> values;
  for (const FailedCheck& check : checks)
    values.push_back(json_object({{"name", json_text(check.name)}, {"what", json_text(check.what)}}));
  return json_array(std::move(values));
}

JsonValue timing_value(const Timing& timing) {
  return json_object({{"wall_s", json_number(timing.wall_s)},
                      {"cpu_s", json_number(timing.cpu_s)},
                      {"prepare_s", json_number(timing.prepare_s)}});
}

JsonValue environment_value(const Environment& environment) {
  return json_object({{"cpu", json_text(environment.cpu)},
                      {"compiler", json_text(environment.compiler)},
                      {"flags", json_text(environment.flags)},
                      {"commit", json_text(environment.commit)},
                      {"threads", json_number(environment.threads)}});
}

JsonValue claim_value(const std::optional<Claim>& claim) {
  return json_or_null(claim, [](Claim c) { return json_text(std::string(word(c))); });
}

JsonMembers result_members(const Instance& instance, const SolveRun& run, const Environment& environment) {
  return {{"format", json_text("gcsbench-result/1")},
          {"instance", instance.document},
          {"strategy", json_text(run.strategy)},
          {"options", options_value(run.options)},
          {"seed", json_count(run.seed)},
          {"status", json_text(std::string(word(run.status)))},
          {"reason", json_text(run.reason)},
          {"claim", claim_value(run.claim)},
          {"counts", counts_value(run.assessment.counts)},
          {"failed_checks", failed_checks_value(run.assessment.failed_checks)},
          {"solutions", solutions_value(instance.problem, run.assessment.solutions)},
          {"path", path_value(run)},
          {"statistics", statistics_value(run.work)},
          {"timing", timing_value(run.timing)},
          {"environment", environment_value(environment)}};
}

/// One element a line for the long array, one line for everything else.
std::string member_text(const std::string& name, const JsonValue& value) {
  if (name != "solutions" || value.elements.empty()) return to_text(value, -1);
  std::string text = "[";
  for (const JsonValue& element : value.elements)
    text += (text.size() > 1 ? ",\n  " : "\n  ") + to_text(element, -1);
  return text + "\n ]";
}

}  // namespace

std::string result_text(const Instance& instance, const SolveRun& run, const Environment& environment) {
  std::string text = "{";
  for (const auto& [name, value] : result_members(instance, run, environment))
    text += (text.size() > 1 ? ",\n \"" : "\n \"") + name + "\": " + member_text(name, value);
  return text + "\n}\n";
}

}  // namespace gcs
