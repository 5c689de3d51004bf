#include "solvers/tests/reduction/compared_answers.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/elements/element_order.hpp"
#include "solvers/figures/solution_classes.hpp"

namespace gcs::samples {

Answer answer_to(const ProblemStatement& problem, const std::string& reduce, const std::string& strategy) {
  return solve(Scene::unchecked(problem), strategy, {{"reduce", reduce}}, {.certify = true});
}

std::uint64_t real_ones(const Answer& answer) {
  return static_cast<std::uint64_t>(std::ranges::count_if(
      answer.solutions, [](const AssessedSolution& solution) { return solution.is_real(); }));
}

void check_count(const Answer& answer, std::size_t count) {
  INFO(answer.strategy << ": " << answer.reason);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.failed_checks.empty());
  CHECK(answer.solutions.size() == count);
  REQUIRE(answer.proofs);
  CHECK(answer.proofs->classes == count);
  CHECK(real_ones(answer) >= 1);
}

int classes_of(const Scene& scene, const Answer& a, const Answer& b) {
  std::vector<Figure> figures;
  std::vector<SolutionAccuracy> accuracies;
  for (const Answer* answer : {&a, &b})
    for (const AssessedSolution& solution : answer->solutions) {
      figures.push_back(scene.in_scene_unit(solution.figure));
      accuracies.push_back({solution.condition});
    }
  return solution_classes(scene, figures, accuracies).count();
}

void check_same_in_one_piece(const ProblemStatement& problem, std::size_t count) {
  const Answer placed = answer_to(problem), whole = answer_to(problem, "off");
  check_count(placed, count);
  check_count(whole, count);
  CHECK(real_ones(placed) == real_ones(whole));
  CHECK(classes_of(Scene::unchecked(problem), placed, whole) == static_cast<int>(count));
}

std::vector<std::string> placed_names(const ProblemStatement& problem) {
  const std::optional<ElementOrder> order = element_order(Scene::unchecked(problem));
  std::vector<std::string> names;
  if (order)
    for (const PlacingStep& step : order->steps)
      if (!step.is_core()) names.push_back(step.name);
  return names;
}

int cores_of(const ProblemStatement& problem) {
  const std::optional<ElementOrder> order = element_order(Scene::unchecked(problem));
  return order ? static_cast<int>(std::ranges::count_if(
                     order->steps, [](const PlacingStep& step) { return step.is_core(); }))
               : 0;
}

}  // namespace gcs::samples
