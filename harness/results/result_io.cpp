#include "harness/results/result_io.hpp"

#include <utility>

#include "harness/base/record_fields.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

namespace {

JsonValue vector_value(const Eigen::Vector3d& vector, int dimension) {
  std::vector<JsonValue> coordinates;
  for (int i = 0; i < dimension; ++i) coordinates.push_back(json_number(vector[i]));
  return json_array(std::move(coordinates));
}

/// Every coordinate as [re, im].
JsonValue vector_value(const Eigen::Vector3d& real, const Eigen::Vector3d& imaginary, int dimension) {
  std::vector<JsonValue> coordinates;
  for (int i = 0; i < dimension; ++i)
    coordinates.push_back(json_array({json_number(real[i]), json_number(imaginary[i])}));
  return json_array(std::move(coordinates));
}

JsonValue line_value(const LinePosition& line) {
  return json_object(
      {{"point", vector_value(line.point, 3)}, {"direction", vector_value(line.direction, 3)}});
}

JsonValue line_value(const LinePosition& real, const LinePosition& imaginary) {
  return json_object({{"point", vector_value(real.point, imaginary.point, 3)},
                      {"direction", vector_value(real.direction, imaginary.direction, 3)}});
}

JsonValue points_value(const ProblemStatement& problem, const Figure& figure) {
  JsonMembers points;
  for (std::size_t i = 0; i < problem.points.size(); ++i) {
    const auto p = static_cast<Eigen::Index>(i);
    points.emplace_back(problem.points[i],
                        figure.is_real()
                            ? vector_value(figure.points.col(p), problem.dimension)
                            : vector_value(figure.points.col(p), figure.imaginary.col(p), problem.dimension));
  }
  return json_object(std::move(points));
}

JsonValue lines_value(const ProblemStatement& problem, const Figure& figure) {
  JsonMembers lines;
  for (std::size_t i = 0; i < problem.lines.size(); ++i)
    lines.emplace_back(problem.lines[i], figure.is_real()
                                             ? line_value(figure.lines[i])
                                             : line_value(figure.lines[i], figure.imaginary_lines[i]));
  return json_object(std::move(lines));
}

JsonValue solution_value(const ProblemStatement& problem, const AssessedSolution& solution) {
  return json_object({{"points", points_value(problem, solution.figure)},
                      {"lines", lines_value(problem, solution.figure)},
                      {"real", json_boolean(solution.figure.is_real())},
                      {"multiplicity", json_number(solution.multiplicity)},
                      {"residual", json_number(solution.residual)},
                      {"condition", json_number(solution.condition)},
                      {"error_bound", json_or_null(solution.error_bound, json_number)},
                      {"certified", json_boolean(solution.certified)}});
}

JsonValue solutions_value(const ProblemStatement& problem, const std::vector<AssessedSolution>& solutions) {
  std::vector<JsonValue> values;
  for (const AssessedSolution& solution : solutions) values.push_back(solution_value(problem, solution));
  return json_array(std::move(values));
}

/// Makes the members of an object of what a list of fields visits.
class MemberWriter {
 public:
  explicit MemberWriter(JsonMembers& members) : members_(members) {}

  template <typename T>
  void operator()(const std::string& name, const T& value) const {
    members_.emplace_back(name, to_value(value));
  }
  template <typename T>
  void operator()(const std::string& name, const std::optional<T>& value) const {
    members_.emplace_back(name, json_or_null(value, [](const T& v) { return to_value(v); }));
  }

 private:
  static JsonValue to_value(double value) { return json_number(value); }
  static JsonValue to_value(int value) { return json_number(value); }
  static JsonValue to_value(std::int64_t value) { return json_count(static_cast<std::uint64_t>(value)); }
  static JsonValue to_value(std::uint64_t value) { return json_count(value); }
  static JsonValue to_value(const Natural& value) { return json_count(value); }
  static JsonValue to_value(const std::string& value) { return json_text(value); }

  JsonMembers& members_;
};

/// Null for a strategy that follows no path in the lengths.
JsonValue path_value(const SolveRun& run) {
  if (run.claim != Claim::on_path && run.claim != Claim::on_path_of_core) return json_null();
  std::vector<JsonValue> crossings;
  for (const AssessedCrossing& crossing : run.crossings)
    crossings.push_back(json_object({{"solution", json_or_null(crossing.solution, json_number)},
                                     {"direction", json_number(crossing.direction)}}));
  return json_array(std::move(crossings));
}

/// In lowest terms; null where it is not determined.
JsonValue exponent_value(const PathEnds& ends) {
  return json_or_null(exponent(ends), [](const Exponent& e) {
    return json_array({json_number(e.numerator), json_number(e.denominator)});
  });
}

JsonValue ends_value(const std::vector<PathEnds>& all) {
  std::vector<JsonValue> values;
  for (const PathEnds& ends : all)
    values.push_back(json_object(
        {{"end", json_text(std::string(word(ends.end)))},
         {"cause", json_text(ends.cause)},
         {"winding_number", ends.winding_number > 0 ? json_number(ends.winding_number) : json_null()},
         {"exponent", exponent_value(ends)},
         {"proven", json_boolean(ends.proven)},
         {"paths", json_count(ends.paths)}}));
  return json_array(std::move(values));
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
                      {"prepare_s", json_number(timing.prepare_s)},
                      {"certify_s", json_or_null(timing.certify_s, json_number)},
                      {"recalled_steps", json_count(static_cast<std::uint64_t>(timing.recalled_steps))}});
}

JsonValue claim_value(const std::optional<Claim>& claim) {
  return json_or_null(claim, [](Claim c) { return json_text(std::string(word(c))); });
}

JsonValue totals_value(const SolutionTotals& totals) {
  JsonMembers members;
  visit_totals(totals, MemberWriter(members));
  return json_object(std::move(members));
}

JsonMembers result_members(const Instance& instance, const SolveRun& run, const Environment& environment) {
  JsonMembers counts, statistics, origin;
  visit_counts(run.counts, MemberWriter(counts));
  visit_work(run.work, MemberWriter(statistics));
  visit_particulars(run.particulars, MemberWriter(statistics));
  visit_environment(environment, MemberWriter(origin));
  return {{"format", json_text("gcsbench-result/1")},
          {"instance", instance.document},
          {"strategy", json_text(run.strategy)},
          {"options", options_value(run.options)},
          {"seed", json_count(run.seed)},
          {"status", json_text(std::string(word(run.status)))},
          {"reason", json_text(run.reason)},
          {"claim", claim_value(run.claim)},
          {"counts", json_object(std::move(counts))},
          {"totals", json_or_null(run.totals, totals_value)},
          {"proofs", proofs_value(run.proofs)},
          {"failed_checks", failed_checks_value(run.failed_checks)},
          {"solutions", solutions_value(instance.problem, run.solutions)},
          {"path", path_value(run)},
          {"ends", ends_value(run.ends)},
          {"statistics", json_object(std::move(statistics))},
          {"timing", timing_value(run.timing)},
          {"environment", json_object(std::move(origin))}};
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

JsonValue proofs_value(const std::optional<Proofs>& proofs) {
  return json_or_null(proofs, [](const Proofs& p) {
    const auto text = [](const std::string& reason) { return json_text(reason); };
    const auto count = [](const Natural& number) { return json_count(number); };
    if (p.why_none) return json_object({{"why_none", json_or_null(p.why_none, text)}});
    return json_object({{"why_none", json_null()},
                        {"classes", json_count(p.classes)},
                        {"real", json_count(p.real)},
                        {"clusters", json_count(p.clusters)},
                        {"in_clusters", json_count(p.in_clusters)},
                        {"most_bits", json_number(p.most_bits)},
                        {"generic", json_or_null(p.generic, count)},
                        {"limit", json_or_null(p.limit, count)},
                        {"limit_is_exact", json_boolean(p.limit_is_exact)},
                        {"complete", json_boolean(p.are_complete())},
                        {"generic_complete", json_boolean(p.generic && p.meets_limit(*p.generic))}});
  });
}

std::string result_text(const Instance& instance, const SolveRun& run, const Environment& environment) {
  std::string text = "{";
  for (const auto& [name, value] : result_members(instance, run, environment))
    text += (text.size() > 1 ? ",\n \"" : "\n \"") + name + "\": " + member_text(name, value);
  return text + "\n}\n";
}

}  // namespace gcs
