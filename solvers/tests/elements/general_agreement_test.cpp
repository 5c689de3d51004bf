/// Strategies that share no more than a tracker, on general scenes.

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/figures/solution_classes.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/cayley_menger.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/strategies/newton_multistart.hpp"
#include "solvers/strategies/polyhedral.hpp"
#include "solvers/strategies/system_paths.hpp"
#include "solvers/tests/elements/general_samples.hpp"

using namespace gcs;
using samples::random_octahedral;
using samples::random_platform;
using samples::RandomNumbers;

namespace {

/// In how many classes the solutions of both answers fall.
int classes_of(const Scene& scene, const Answer& a, const Answer& b) {
  std::vector<Figure> figures;
  std::vector<SolutionAccuracy> accuracies;
  for (const Answer* answer : {&a, &b})
    for (const AssessedSolution& solution : answer->solutions) {
      figures.push_back(solution.figure);
      accuracies.push_back({solution.condition});
    }
  return solution_classes(scene, figures, accuracies).count();
}

/// Whether the distances between points of both agree, as far as their proven errors say that they must.
bool may_be_same(const AssessedSolution& a, const AssessedSolution& b) {
  const double most = 2 * (a.error_bound.value() + b.error_bound.value()) + 1e-14;
  const auto count = a.figure.points.cols();
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index k = 0; k < i; ++k) {
      const auto length = [&](const AssessedSolution& of) {
        return (of.figure.points.col(i) - of.figure.points.col(k)).norm();
      };
      if (std::abs(length(a) - length(b)) > most) return false;
    }
  return true;
}

/// Whether every real solution of `some` is one of `all`.
bool are_real_solutions_among(const Answer& some, const Answer& all) {
  return std::all_of(some.solutions.begin(), some.solutions.end(), [&](const AssessedSolution& a) {
    return !a.is_real() || std::any_of(all.solutions.begin(), all.solutions.end(),
                                       [&](const auto& b) { return b.is_real() && may_be_same(a, b); });
  });
}

std::int64_t particular(const Answer& answer, std::string_view name) {
  const auto found = std::ranges::find(answer.particulars, name, &Particular::name);
  return found == answer.particulars.end() ? -1 : found->value;
}

void check_agreement(const ProblemStatement& problem, std::size_t count, std::uint64_t seed) {
  const Scene scene = Scene::unchecked(problem);
  const Answer loops = solve(scene, Monodromy{.seed = seed, .certify = true});
  const Answer cells = solve(scene, Polyhedral{.seed = seed, .certify = true});
  INFO(cells.reason);
  CHECK(cells.status == RunStatus::complete);
  CHECK(cells.failed_checks.empty());
  REQUIRE(cells.solutions.size() == count);
  REQUIRE(loops.solutions.size() == count);
  CHECK(classes_of(scene, loops, cells) == static_cast<int>(count));
  REQUIRE(cells.proofs);
  CHECK(cells.proofs->classes == count);
  CHECK(are_real_solutions_among(loops, cells));
  CHECK(are_real_solutions_among(cells, loops));
}

}  // namespace

TEST_CASE("mixed cells lead to the same solutions of octahedral scenes as loops") {
  RandomNumbers random(21);
  for (const int planes : {1, 2, 3})
    check_agreement(random_octahedral(planes, random), 8, static_cast<std::uint64_t>(planes));
}

TEST_CASE("determinants of points and planes have the solutions of octahedral scenes that loops find") {
  RandomNumbers random(28);
  for (int i = 0; i < 12; ++i) {
    const int planes = i % 3 + 1;
    const Scene scene = Scene::unchecked(random_octahedral(planes, random));
    const Answer loops = solve(scene, Monodromy{.certify = true});
    REQUIRE(loops.solutions.size() == 8);
    const auto real = std::ranges::count_if(loops.solutions, [](const auto& of) { return of.is_real(); });
    for (const DiagonalMethod method : {DiagonalMethod::eigenvalues, DiagonalMethod::univariate}) {
      const Answer answer = solve(scene, CayleyMenger{.certify = true, .method = method});
      INFO(planes << " planes: " << answer.reason);
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.failed_checks.empty());
      REQUIRE(answer.solutions.size() == 8);
      REQUIRE(answer.proofs);
      CHECK(answer.proofs->classes == 8);
      CHECK(classes_of(scene, loops, answer) == 8);
      CHECK(are_real_solutions_among(loops, answer));
      CHECK(are_real_solutions_among(answer, loops));
      if (method == DiagonalMethod::univariate) {  // counted with their mirror images
        CHECK(particular(answer, "eliminated_degree") == 16);
        CHECK(particular(answer, "proven_real_solutions") == 2 * real);
      }
    }
  }
}

TEST_CASE("determinants are of octahedra of points and planes that see a side, and exact ones of fractions") {
  RandomNumbers random(29);
  const ProblemStatement octahedral = random_octahedral(2, random);
  const auto status = [](const ProblemStatement& problem, DiagonalMethod method) {
    return solve(Scene::unchecked(problem), CayleyMenger{.method = method}).status;
  };
  ProblemStatement in_degrees = octahedral;
  for (Relation& relation : in_degrees.relations)
    if (relation.type == "angle") {
      relation.form = Relation::Form::degrees;
      relation.given = {std::acos(relation.given.value) * 180 / M_PI, ""};
    }
  CHECK(status(in_degrees, DiagonalMethod::eigenvalues) == RunStatus::complete);
  CHECK(status(in_degrees, DiagonalMethod::univariate) == RunStatus::unsupported);
  ProblemStatement without_side = octahedral;
  for (Relation& relation : without_side.relations)
    if (relation.type == "distance") relation = {relation.id, "on", relation.of, Relation::Form::none};
  CHECK(status(without_side, DiagonalMethod::eigenvalues) == RunStatus::unsupported);
  CHECK(status(random_platform(3, random), DiagonalMethod::eigenvalues) == RunStatus::unsupported);
}

TEST_CASE("mixed cells lead to the same postures of a planar platform as loops") {
  RandomNumbers random(22);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) check_agreement(random_platform(2, random), 6, seed);
}

TEST_CASE("what Newton's method finds of general scenes are the real solutions that loops find") {
  RandomNumbers random(24);
  std::vector<ProblemStatement> problems{random_platform(2, random)};
  for (const int planes : {1, 2, 3}) problems.push_back(random_octahedral(planes, random));
  for (const ProblemStatement& problem : problems) {
    const Scene scene = Scene::unchecked(problem);
    const Answer loops = solve(scene, Monodromy{.certify = true});
    const Answer newton = solve(scene, NewtonMultistart{.seed = 3, .certify = true});
    INFO(newton.reason);
    CHECK(newton.status == RunStatus::complete);
    CHECK(newton.failed_checks.empty());
    REQUIRE(!newton.solutions.empty());
    CHECK(classes_of(scene, loops, newton) == static_cast<int>(loops.solutions.size()));
    CHECK(are_real_solutions_among(newton, loops));
  }
}

TEST_CASE("Newton's method finds the same on any number of threads, another seed the same solutions") {
  RandomNumbers random(25);
  const Scene scene = Scene::unchecked(random_octahedral(2, random));
  const Answer one = solve(scene, NewtonMultistart{.seed = 4});
  const Answer two = solve(scene, NewtonMultistart{.seed = 4, .threads = 2});
  const Answer other = solve(scene, NewtonMultistart{.seed = 5, .starts = 2000, .unseen = 1e-3});
  REQUIRE(!one.solutions.empty());
  REQUIRE(two.solutions.size() == one.solutions.size());
  for (std::size_t i = 0; i < one.solutions.size(); ++i) {
    CHECK(two.solutions[i].figure.points == one.solutions[i].figure.points);
    CHECK(two.solutions[i].figure.planes.front().normal == one.solutions[i].figure.planes.front().normal);
  }
  CHECK(classes_of(scene, one, other) == static_cast<int>(other.solutions.size()));
}

TEST_CASE("the equations of a general scene, written down exactly, have the solutions that loops find") {
  RandomNumbers random(26);
  for (const ProblemStatement& problem :
       {random_platform(2, random), random_octahedral(1, random), random_octahedral(3, random)}) {
    const Scene scene = Scene::unchecked(problem);
    const Answer loops = solve(scene, Monodromy{.certify = true});
    const Answer paths =
        solve(scene, SystemPaths{.seed = 2, .certify = true, .system = SystemPaths::System::echelon});
    INFO(paths.reason);
    CHECK(paths.status == RunStatus::complete);
    CHECK(paths.failed_checks.empty());
    REQUIRE(paths.solutions.size() == loops.solutions.size());
    CHECK(classes_of(scene, loops, paths) == static_cast<int>(loops.solutions.size()));
    CHECK(are_real_solutions_among(paths, loops));
    CHECK(are_real_solutions_among(loops, paths));
  }
}

TEST_CASE("Bezout's paths lead to the postures of a planar platform too") {
  RandomNumbers random(27);
  const Scene scene = Scene::unchecked(random_platform(2, random));
  SystemPaths asked{.system = SystemPaths::System::quadrics, .start = PathStart::total_degree};
  const Answer paths = solve(scene, asked);
  CHECK(paths.status == RunStatus::complete);
  CHECK(paths.solutions.size() == 6);
  asked.system = SystemPaths::System::quartics;  // of octahedra
  CHECK(solve(scene, asked).status == RunStatus::unsupported);
}

TEST_CASE("a general scene has as many solutions whether mirror images are followed or divided out") {
  RandomNumbers random(23);
  const Scene scene = Scene::unchecked(random_octahedral(3, random));
  const auto start_paths = [&](HomotopySettings::MirrorImages images) {
    Polyhedral polyhedral;
    polyhedral.tracking.mirror_images = images;
    const Answer answer = solve(scene, polyhedral);
    CHECK(answer.status == RunStatus::complete);
    CHECK(answer.solutions.size() == 8);
    return particular(answer, "start_paths");
  };
  CHECK(start_paths(HomotopySettings::MirrorImages::followed) >
        start_paths(HomotopySettings::MirrorImages::divided));
  CHECK(start_paths(HomotopySettings::MirrorImages::divided) > 0);
}
