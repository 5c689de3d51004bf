#include "harness/cli/standing_view.hpp"

#include <fmt/format.h>

#include <map>

#include "harness/base/summary_line.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {
namespace {

std::string standing_text(const ProblemStatement& problem, const std::vector<AssessedSolution>& solutions,
                          Standing standing, std::string_view against) {
  std::size_t count = 0;
  std::map<int, std::size_t> of_relation;
  for (const AssessedSolution& solution : solutions) {
    if (!solution.is_real() || solution.signs.standing != standing) continue;
    ++count;
    for (const int relation : solution.signs.relations) ++of_relation[relation];
  }
  if (count == 0) return "";
  std::string text;
  for (const auto& [relation, number] : of_relation)
    text += fmt::format("{}{} {} '{}'", text.empty() ? "" : ", ", number, against,
                        problem.relations[static_cast<std::size_t>(relation)].id);
  return summary_line(word(standing), fmt::format("{} more real {} of the equations: {}", count,
                                                  count == 1 ? "solution" : "solutions", text));
}

}  // namespace

std::string standings_text(const ProblemStatement& problem, const Assessment& assessment) {
  return standing_text(problem, assessment.solutions, Standing::not_as_stated, "against") +
         standing_text(problem, assessment.solutions, Standing::undecided, "next to a sign change of");
}

}  // namespace gcs
