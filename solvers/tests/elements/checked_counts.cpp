#include "solvers/tests/elements/checked_counts.hpp"

#include <catch2/catch.hpp>

#include "solvers/elements/general_structure.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/strategies/polyhedral.hpp"

namespace gcs::samples {

int classes_of(const Scene& scene, const std::vector<const Answer*>& answers, const Figure& figure) {
  std::vector<Figure> figures{figure};
  std::vector<SolutionAccuracy> accuracies{{1e6}};
  for (const Answer* answer : answers)
    for (const AssessedSolution& solution : answer->solutions) {
      figures.push_back(solution.figure);
      accuracies.push_back({solution.condition});
    }
  return solution_classes(scene, figures, accuracies).count();
}

void check_proven(const Answer& answer, std::size_t count) {
  INFO(answer.reason);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.failed_checks.empty());
  CHECK(answer.solutions.size() == count);
  REQUIRE(answer.proofs);
  CHECK(answer.proofs->classes == count);
}

void check_complete(const Answer& answer, std::size_t count) {
  check_proven(answer, count);
  CHECK(answer.proofs->real >= 1);
}

Answer check_counts(const ProblemStatement& problem, const Figure& figure, std::size_t count,
                    std::uint64_t seed) {
  const Scene scene = Scene::unchecked(problem);
  REQUIRE_FALSE(why_no_system(scene));
  CHECK(analyse_general_structure(scene).well_posed());
  const Figure made = scene.in_scene_unit(figure);
  CHECK(relative_residual(scene, made) <= 1e-12);
  Answer loops = solve(scene, Monodromy{.seed = seed, .certify = true});
  check_complete(loops, count);
  const Answer cells = solve(scene, Polyhedral{.seed = seed, .threads = 2, .certify = true});
  check_complete(cells, count);
  CHECK(classes_of(scene, {&loops, &cells}, made) == static_cast<int>(count));
  return loops;
}

}  // namespace gcs::samples
