#include "harness/results/reference_io.hpp"

#include <fmt/format.h>

#include <utility>

#include "harness/base/document_text.hpp"
#include "harness/results/decimal_json.hpp"
#include "harness/results/file_formats.hpp"
#include "harness/results/result_io.hpp"
#include "harness/results/verify.hpp"
#include "solvers/answers/certify.hpp"
#include "solvers/certificates/decimal_figure.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {
namespace {

JsonValue solution_value(const ProblemStatement& problem, const DecimalFigure& figure, bool is_real) {
  JsonMembers members = decimal_members(problem, figure, is_real);
  members.emplace(members.begin(), "real", json_boolean(is_real));
  return json_object(std::move(members));
}

void require_proven(const StoredResult& result, const Verification& verification) {
  if (verification.mismatches.empty()) return;
  throw InputError(result.instance.origin, "/solutions",
                   "the result does not verify: " + verification.mismatches.front().what,
                   "solve again, and look at what `gcsbench verify` says");
}

/// Of the solutions that are kept, those that are proven to so many digits.
std::vector<JsonValue> solution_values(const StoredResult& result, const ReferenceSettings& settings) {
  const Scene& scene = result.scene;
  const SceneEquations equations(scene);
  std::vector<Figure> kept;
  for (const AssessedSolution& solution : result.answer.solutions)
    if (solution.is_real() || !settings.only_real) kept.push_back(solution.figure);
  const auto figures = decimal_figures(equations, scene, kept, settings.digits, settings.threads);
  std::vector<JsonValue> values;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (figures[i]) values.push_back(solution_value(scene.problem(), *figures[i], kept[i].is_real()));
  return values;
}

}  // namespace

std::string reference_text(const StoredResult& result, const ReferenceSettings& settings, Monitor& progress) {
  const Verification verification = verify(result, settings.threads, &progress);
  require_proven(result, verification);
  progress.progress(fmt::format("proving {} digits", settings.digits), -1);
  const std::vector<JsonValue> solutions = solution_values(result, settings);
  const std::size_t wanted = settings.only_real ? verification.proofs.real : result.answer.solutions.size();
  if (solutions.size() != wanted)
    throw InputError(result.instance.origin, "/solutions",
                     fmt::format("only {} of {} solutions are proven to {} digits", solutions.size(), wanted,
                                 settings.digits),
                     "ask for fewer digits");
  const Answer& answer = result.answer;
  return document_text(reference_format, [&](DocumentWriter& document) {
    document.member("instance", result.instance.document);
    document.member("origin",
                    json_object({{"strategy", json_text(answer.strategy)},
                                 {"claim", json_text(answer.claim ? std::string(word(*answer.claim)) : "")},
                                 {"digits", json_number(settings.digits)},
                                 {"only_real", json_boolean(settings.only_real)}}));
    document.member("proofs", proofs_value(verification.proofs));
    document.list("solutions", solutions, [](const JsonValue& solution) { return solution; });
  });
}

}  // namespace gcs
