#include "harness/results/reference_io.hpp"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "harness/results/result_io.hpp"
#include "harness/results/verify.hpp"
#include "solvers/answers/certify.hpp"
#include "solvers/certificates/decimal_figure.hpp"
#include "solvers/reading/figure_json.hpp"

namespace gcs {
namespace {

constexpr std::string_view format_name = "gcsbench-reference/1";

JsonValue decimal_value(const DecimalNumber& number, bool is_real) {
  return is_real ? json_text(number.re) : json_texts({number.re, number.im});
}

JsonValue vector_value(const DecimalVector& vector, int dimension, bool is_real) {
  const auto number_value = [&](const DecimalNumber& number) { return decimal_value(number, is_real); };
  return json_array_of(std::span(vector).first(static_cast<std::size_t>(dimension)), number_value);
}

JsonValue solution_value(const ProblemStatement& problem, const DecimalFigure& figure, bool is_real) {
  const auto point_value = [&](const DecimalVector& point) {
    return vector_value(point, problem.dimension, is_real);
  };
  const auto line_value = [&](const DecimalFigure::Line& line) {
    return json_line(vector_value(line.point, problem.dimension, is_real),
                     vector_value(line.direction, problem.dimension, is_real));
  };
  const auto plane_value = [&](const DecimalFigure::Plane& plane) {
    return json_plane(vector_value(plane.normal, 3, is_real), decimal_value(plane.offset, is_real));
  };
  JsonMembers members{{"real", json_boolean(is_real)},
                      {"points", json_object_of(problem.points, figure.points, point_value)},
                      {"lines", json_object_of(problem.lines, figure.lines, line_value)}};
  if (!problem.planes.empty())
    members.emplace_back("planes", json_object_of(problem.planes, figure.planes, plane_value));
  members.emplace_back("error_bound", json_number(figure.error));
  members.emplace_back("unique_within", json_number(figure.unique));
  members.emplace_back("bits", json_number(figure.bits));
  return json_object(std::move(members));
}

void require_proven(const StoredResult& result, const Verification& verification) {
  if (verification.mismatches.empty()) return;
  throw InputError(result.instance.origin, "/solutions",
                   "the result does not verify: " + verification.mismatches.front().what,
                   "solve again, and look at what `gcsbench verify` says");
}

/// One text for each solution that is kept.
std::vector<std::string> solution_texts(const StoredResult& result, const ReferenceSettings& settings) {
  const Scene& scene = result.scene;
  const SceneEquations equations(scene);
  std::vector<Figure> kept;
  for (const AssessedSolution& solution : result.listed.solutions)
    if (solution.is_real() || !settings.only_real) kept.push_back(solution.figure);
  const auto figures = decimal_figures(equations, scene, kept, settings.digits, settings.threads);
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (figures[i])
      texts.push_back(to_text(solution_value(scene.problem(), *figures[i], kept[i].is_real()), -1));
  return texts;
}

}  // namespace

std::string reference_text(const StoredResult& result, const ReferenceSettings& settings, Monitor& progress) {
  const Verification verification = verify(result, settings.threads, &progress);
  require_proven(result, verification);
  progress.progress(fmt::format("proving {} digits", settings.digits), -1);
  const std::vector<std::string> solutions = solution_texts(result, settings);
  const std::size_t wanted = settings.only_real ? verification.proofs.real : result.listed.solutions.size();
  if (solutions.size() != wanted)
    throw InputError(result.instance.origin, "/solutions",
                     fmt::format("only {} of {} solutions are proven to {} digits", solutions.size(), wanted,
                                 settings.digits),
                     "ask for fewer digits");
  const JsonValue origin =
      json_object({{"strategy", json_text(result.strategy)},
                   {"claim", json_text(result.claim ? std::string(word(*result.claim)) : "")},
                   {"digits", json_number(settings.digits)},
                   {"only_real", json_boolean(settings.only_real)}});
  return fmt::format(
      "{{\"format\": \"{}\",\n \"instance\": {},\n \"origin\": {},\n \"proofs\": {},\n "
      "\"solutions\": [\n  {}\n ]}}\n",
      format_name, to_text(result.instance.document, -1), to_text(origin, -1),
      to_text(proofs_value(verification.proofs), -1), fmt::join(solutions, ",\n  "));
}

}  // namespace gcs
