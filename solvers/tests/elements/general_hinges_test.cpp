/// Rings of bodies, each hinged to the next. Six close in 16 ways: E. J. F. Primrose, On the input-output equation of
/// the general 7R-mechanism, Mech. Mach. Theory 21 (1986); H. Y. Lee, C. G. Liang, Displacement analysis of the general
/// spatial 7-link 7R mechanism, Mech. Mach. Theory 23 (1988).

#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/elements/general_structure.hpp"
#include "solvers/figures/general_figures.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/strategies/newton_multistart.hpp"
#include "solvers/strategies/polyhedral.hpp"
#include "solvers/tests/elements/general_samples.hpp"

using namespace gcs;
using samples::RandomNumbers;
using samples::ring_of;

namespace {

Figure in_unit(const Scene& scene, const Eigen::Matrix3Xd& points) {
  Figure figure;
  figure.points = points;
  return figure.scaled(-scene.unit_exponent());
}

/// In how many classes the solutions of some answers and the figure fall.
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

void check_complete(const Answer& answer, std::size_t count) {
  INFO(answer.reason);
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.failed_checks.empty());
  CHECK(answer.solutions.size() == count);
  REQUIRE(answer.proofs);
  CHECK(answer.proofs->classes == count);
  CHECK(answer.proofs->real >= 1);
}

/// By loops and by mixed cells; the points that the ring is made of are a solution.
void check_ring(const Eigen::Matrix3Xd& points, std::size_t count, std::uint64_t seed,
                RandomNumbers& random) {
  const Scene scene = Scene::unchecked(ring_of(points, random));
  REQUIRE_FALSE(why_no_system(scene));
  const Figure made = in_unit(scene, points);
  CHECK(general_residual(scene, made) <= 1e-12);
  const Answer loops = solve(scene, Monodromy{.seed = seed, .certify = true});
  check_complete(loops, count);
  const Answer cells = solve(scene, Polyhedral{.seed = seed, .threads = 2, .certify = true});
  check_complete(cells, count);
  CHECK(classes_of(scene, {&loops, &cells}, made) == static_cast<int>(count));
}

}  // namespace

TEST_CASE("six bodies in a ring, each hinged to the next, have 16 postures") {
  RandomNumbers random(41);
  for (std::uint64_t seed = 1; seed <= 2; ++seed) check_ring(random.points(3, 12, 1), 16, seed, random);
}
