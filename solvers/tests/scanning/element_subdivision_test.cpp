/// Proven scans of points, lines and planes against the real ones of all complex solutions, which other strategies find.

#include "solvers/scanning/element_subdivision.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <gcsbench/gcsbench.hpp>
#include <numeric>

#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/elements/measured_scenes.hpp"

namespace gcs {
namespace {

std::vector<int> shuffled(std::size_t count, samples::RandomNumbers& random) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  for (std::size_t i = count; i > 1; --i)
    std::swap(numbers[i - 1],
              numbers[static_cast<std::size_t>(random.uniform(0, 1) * static_cast<double>(i))]);
  return numbers;
}

/// Points, lines and planes in another order each, and lengths 2^exponent times as long.
ProblemStatement restated(ProblemStatement problem, int exponent, samples::RandomNumbers& random) {
  std::vector<int> now;
  for (const std::size_t count : {problem.points.size(), problem.lines.size(), problem.planes.size()}) {
    const auto before = static_cast<int>(now.size());
    for (const int number : shuffled(count, random)) now.push_back(before + number);
  }
  const auto renumber = [&](int& entity) {
    if (entity >= 0) entity = now[static_cast<std::size_t>(entity)];
  };
  for (DistanceConstraint& distance : problem.constraints) {
    for (int& entity : distance.between) renumber(entity);
    distance.given.value = std::ldexp(distance.given.value, (distance.is_squared ? 2 : 1) * exponent);
  }
  for (Relation& relation : problem.relations) {
    for (Operand& operand : relation.of) renumber(operand.entity);
    if (relation.type == "distance") relation.given.value = std::ldexp(relation.given.value, exponent);
  }
  for (RigidBody& body : problem.bodies)
    for (BodyElement& element : body.elements) {
      renumber(element.entity);
      for (Decimal& number : element.numbers) number.value = std::ldexp(number.value, exponent);
    }
  problem.reference.reset();
  problem.sketch.reset();
  return problem;
}

std::size_t real_solutions(const Answer& answer) {
  return static_cast<std::size_t>(
      std::ranges::count_if(answer.solutions, [](const auto& solution) { return solution.is_real(); }));
}

/// Proven to be all, each of them certified.
std::size_t proven_real_solutions(const Scene& scene, const OptionMap& options = {}) {
  const Answer scan = solve(scene, "plan-scan", options, {.certify = true});
  INFO(scan.reason);
  CHECK(scan.status == RunStatus::complete);
  CHECK(scan.failed_checks.empty());
  for (const auto& solution : scan.solutions) CHECK(solution.certified);
  return real_solutions(scan);
}

}  // namespace

TEST_CASE("a proven scan of points and planes has the real solutions that determinants give") {
  samples::RandomNumbers random(15);
  std::size_t found = 0;
  for (const int planes : {1, 2, 3})
    for (int i = 0; i < 7; ++i) {
      const ProblemStatement problem = samples::random_octahedral(planes, random);
      const std::size_t real = real_solutions(solve(Scene(problem), "cayley-menger"));
      INFO(planes << " planes, scene " << i);
      CHECK(proven_real_solutions(Scene(restated(problem, 11 * i - 30, random))) == real);
      found += real;
    }
  CHECK(found > 42);
}

TEST_CASE("a proven scan of points, lines and planes has the real ones of all complex solutions") {
  samples::RandomNumbers random(52);
  for (const auto& [name, problem] : samples::measured_scenes(random)) {
    if (name == "line beside" || name == "lines") continue;  // 40 and 64 complex solutions
    CAPTURE(name);
    const Scene scene = Scene::unchecked(problem);
    const bool takes_long = name == "beside a body";
    const std::size_t real = real_solutions(solve(scene, takes_long ? "newton-multistart" : "monodromy"));
    CHECK(real > 0);
    CHECK(proven_real_solutions(Scene::unchecked(restated(problem, 5, random))) == real);
  }
}

TEST_CASE("a proven scan has all figures with an angle between segments as it is stated") {
  samples::RandomNumbers random(31);
  std::ptrdiff_t found = 0;
  for (const int dimension : {2, 3})
    for (int i = 0; i < 4; ++i) {
      const Eigen::Matrix3Xd at = random.points(dimension, 4, 2);
      samples::MeasuredProblem measured(dimension, Figure{at, {}});
      measured.distance(0, 1).distance(0, 2).distance(1, 2).distance(0, 3);
      if (dimension == 3) measured.distance(1, 3);
      ProblemStatement problem = measured.problem();
      const double cosine = (at.col(3) - at.col(1)).normalized().dot((at.col(3) - at.col(2)).normalized());
      problem.relations.push_back({"angle", "angle", {{1, 3}, {2, 3}}, Relation::Form::cosine, {cosine, ""}});
      const Scene scene = Scene::unchecked(problem);
      const auto as_stated = [](const Answer& answer) {
        return std::ranges::count_if(answer.solutions,
                                     [](const auto& solution) { return solution.is_as_stated(); });
      };
      const Answer scan = solve(scene, "plan-scan", {}, {.certify = true});
      INFO(dimension << " dimensions, scene " << i << ": " << scan.reason);
      CHECK(scan.status == RunStatus::complete);
      CHECK(as_stated(scan) == as_stated(solve(scene, "monodromy")));
      found += as_stated(scan);
    }
  CHECK(found >= 8);
}

TEST_CASE("a constraint without enclosures is refused by its name") {
  samples::RandomNumbers random(32);
  Figure figure{random.points(3, 3, 2), {}};
  for (int i = 0; i < 2; ++i) figure.lines.push_back({figure.points.col(i), random.point(3, 1).normalized()});
  samples::MeasuredProblem measured(3, figure);
  measured.distance(0, 1).distance(0, 2).distance(1, 2).holds("on", 0, 3).holds("on", 1, 4);
  measured.distance(1, 3).distance(2, 3).distance(2, 4);
  ProblemStatement problem = measured.problem();
  problem.relations.push_back({"apart", "distance", {{3}, {4}}, Relation::Form::length, {0.5, ""}});
  const Answer scan = solve(Scene::unchecked(problem), "plan-scan", {{"reduce", "off"}});
  CHECK(scan.status == RunStatus::unsupported);
  CHECK_THAT(scan.reason, Catch::Contains("unknowns of constraint 'apart'"));
}

}  // namespace gcs
