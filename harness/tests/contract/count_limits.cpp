#include "harness/tests/contract/count_limits.hpp"

#include <fmt/format.h>

#include "solvers/answers/assess.hpp"
#include "solvers/model/released_scene.hpp"

namespace gcs::contract {
namespace {

void require_at_most(const Natural& found, const Natural& limit, std::string_view what,
                     Violations& violations) {
  if (found > limit)
    violations.push_back({"limit", fmt::format("{} {}, at most {}", found.decimal(), what, limit.decimal())});
}

}  // namespace

Violations check_limits(const Scene& scene, const TheoreticalCounts& counts, const SolveReport& report) {
  if (counts.upper_limit() == nullptr) return {};
  Violations violations;
  const Natural limit = counts.upper_limit()->up_to_reflection();
  const Assessment assessment = assess(scene, report);
  require_at_most(assessment.solutions.size(), limit, "classes", violations);
  const auto generic = assessment.counts.generic;
  if (!generic) return violations;
  require_at_most(*generic, limit, "classes at generic lengths", violations);
  if (counts.exact && report.status == SolveStatus::complete && *generic != limit)
    violations.push_back({"limit", fmt::format("{} classes at generic lengths, exactly {}",
                                               generic->decimal(), limit.decimal())});
  return violations;
}

bool has_many_solutions(const Scene& scene) {
  const bool is_released = scene.is_anchored() && !why_not_released(scene);
  const TheoreticalCounts counts =
      theoretical_counts(is_released ? ReleasedScene(scene).scene().problem() : scene.problem());
  const SolutionCount* limit = counts.upper_limit();
  return !limit || limit->up_to_reflection() > Natural(counts.exact ? 100 : 32);
}

}  // namespace gcs::contract
