/// Orientations select among the real solutions, and senses of angles. Expected counts are those of elementary geometry,
/// and of the same scene without an orientation, which other equations describe.

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solvers/solving/problem.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Edges = std::vector<std::array<int, 2>>;
using Points = std::vector<int>;

const std::vector<std::pair<const char*, OptionMap>> complex_strategies{
    {"monodromy", {}}, {"polyhedral", {}}, {"system-paths", {{"system", "quadrics"}}}};

/// The lengths of a random figure; the frame is put in its first points.
ProblemStatement random_scene(int dimension, int points, const Edges& edges, RandomNumbers& random) {
  ProblemStatement problem;
  problem.dimension = dimension;
  for (int i = 0; i < points; ++i) problem.points.push_back("p" + std::to_string(i));
  problem.reference = Reference{0, 1, dimension == 3 ? 2 : -1};
  problem.sketch = Figure{random.points(dimension, points, 2), {}};
  const Eigen::Matrix3Xd& at = problem.sketch->points;
  for (const auto& [a, b] : edges) {
    const std::string id = std::to_string(a) + std::to_string(b);
    problem.constraints.push_back({id, {a, b}, {(at.col(a) - at.col(b)).norm(), ""}, false});
  }
  return problem;
}

Edges all_pairs(const Points& points, const Edges& but = {}) {
  Edges edges;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const std::array edge{points[i], points[j]};
      if (std::find(but.begin(), but.end(), edge) == but.end()) edges.push_back(edge);
    }
  return edges;
}

ProblemStatement oriented(ProblemStatement problem, const std::vector<Points>& of, unsigned signs) {
  for (std::size_t i = 0; i < of.size(); ++i) {
    Relation relation{"side" + std::to_string(i), "orientation", {}, Relation::Form::none};
    for (const int point : of[i]) relation.of.push_back({point});
    relation.sign = (signs >> i & 1U) != 0 ? -1 : 1;
    problem.relations.push_back(relation);
  }
  return problem;
}

double determinant(const Figure& figure, const Points& of) {
  Eigen::Matrix3d ways = Eigen::Matrix3d::Identity();
  for (std::size_t i = 1; i < of.size(); ++i)
    ways.col(static_cast<Eigen::Index>(i) - 1) = figure.points.col(of[i]) - figure.points.col(of[0]);
  return ways.determinant();
}

Answer answer_of(const ProblemStatement& problem, std::string_view strategy = "monodromy",
                 bool certify = true, const OptionMap& options = {}) {
  return solve(Scene::unchecked(problem), strategy, options, {.seed = 1, .certify = certify});
}

std::uint64_t small(const std::optional<Natural>& count) {
  REQUIRE(count);
  return std::stoull(count->decimal());
}

/// Each solution is labelled by its own determinants, and what is counted is what is listed.
void check_labels(const Answer& answer, const std::vector<Points>& of, unsigned signs) {
  std::uint64_t as_stated = 0, others = 0;
  for (const AssessedSolution& solution : answer.solutions) {
    if (!solution.is_real()) continue;
    bool fits = true;
    for (std::size_t i = 0; i < of.size(); ++i)
      fits = fits && (determinant(solution.figure, of[i]) < 0) == ((signs >> i & 1U) != 0);
    CHECK(solution.signs.standing == (fits ? Standing::as_stated : Standing::not_as_stated));
    CHECK(solution.signs.relations.empty() == fits);
    ++(fits ? as_stated : others);
  }
  CHECK(answer.counts.real_up_to_reflection == Natural(as_stated));
  CHECK(answer.counts.not_as_stated == others);
  CHECK(answer.counts.undecided == 0U);
}

struct Total {
  std::uint64_t real = 0, largest = 0;
};

/// Over all choices of signs; each has `complex` solutions, and the opposite choice as many real ones.
Total over_all_signs(const ProblemStatement& problem, const std::vector<Points>& of, std::uint64_t complex) {
  Total total;
  std::vector<std::uint64_t> real;
  const unsigned choices = 1U << of.size();
  for (unsigned signs = 0; signs < choices; ++signs) {
    const Answer answer = answer_of(oriented(problem, of, signs));
    INFO("signs " << signs << ": " << answer.reason);
    CHECK(answer.status == RunStatus::complete);
    CHECK(answer.failed_checks.empty());
    CHECK(small(answer.counts.complex_up_to_reflection) == complex);
    REQUIRE(answer.proofs);
    CHECK(answer.proofs->classes == complex);
    real.push_back(small(answer.counts.real_up_to_reflection));
    CHECK(answer.proofs->real == real.back());
    check_labels(answer, of, signs);
    total.real += real.back();
    total.largest = std::max(total.largest, real.back());
  }
  for (unsigned signs = 0; signs < choices; ++signs) CHECK(real[signs] == real[choices - 1 - signs]);
  return total;
}

/// As many as there are without orientations, each solution and its mirror image.
void check_sum(const ProblemStatement& problem, const std::vector<Points>& of) {
  const Answer without = answer_of(problem);
  CHECK(without.status == RunStatus::complete);
  CHECK(over_all_signs(problem, of, 2 * small(without.counts.complex_up_to_reflection)).real ==
        2 * small(without.counts.real_up_to_reflection));
}

}  // namespace

TEST_CASE("of what is placed point by point each choice of orientations selects one figure") {
  RandomNumbers random(51);
  struct Sample {
    int dimension;
    int points;
    Edges edges;
    std::vector<Points> of;
    std::uint64_t complex;
  };
  const std::vector<Sample> samples{
      {2, 3, all_pairs({0, 1, 2}), {{0, 1, 2}}, 2},
      {2, 4, all_pairs({0, 1, 2, 3}, {{2, 3}}), {{2, 1, 0}, {0, 1, 3}}, 4},
      {3, 4, all_pairs({0, 1, 2, 3}), {{3, 1, 2, 0}}, 2},
      {3, 5, all_pairs({0, 1, 2, 3, 4}, {{3, 4}}), {{0, 1, 2, 3}, {0, 4, 1, 2}}, 4}};
  for (const Sample& sample : samples)
    for (int i = 0; i < 3; ++i) {
      const ProblemStatement problem = random_scene(sample.dimension, sample.points, sample.edges, random);
      const Total total = over_all_signs(problem, sample.of, sample.complex);
      CHECK(total.real == sample.complex);
      CHECK(total.largest == 1);
    }
}

TEST_CASE(
    "two tetrahedra on a hinge, held by a distance, have two postures for each choice of orientations") {
  // Whatever their sides, a point of each goes round the hinge on the same circle.
  RandomNumbers random(52);
  Edges edges = all_pairs({0, 1, 2, 3});
  for (const auto& edge : all_pairs({0, 1, 4, 5}))
    if (edge != std::array{0, 1}) edges.push_back(edge);
  edges.push_back({3, 4});
  const std::vector<Points> of{{0, 1, 2, 3}, {0, 1, 4, 5}};
  for (int i = 0; i < 2; ++i) {
    const Total total = over_all_signs(random_scene(3, 6, edges, random), of, 8);
    CHECK(total.real == 8);
    CHECK(total.largest == 2);
  }
}

TEST_CASE("over all orientations there are as many real solutions as without one, mirror images told apart") {
  RandomNumbers random(53);
  const Edges octahedron = all_pairs({0, 1, 2, 3, 4, 5}, {{0, 3}, {1, 4}, {2, 5}});
  const Edges prism{{0, 1}, {1, 2}, {0, 2}, {3, 4}, {4, 5}, {3, 5}, {0, 3}, {1, 4}, {2, 5}};
  const Edges k33{{0, 3}, {0, 4}, {0, 5}, {1, 3}, {1, 4}, {1, 5}, {2, 3}, {2, 4}, {2, 5}};
  check_sum(random_scene(3, 6, octahedron, random), {{0, 1, 2, 3}, {2, 3, 4, 5}});
  check_sum(random_scene(2, 6, prism, random), {{0, 1, 2}, {3, 4, 5}});
  check_sum(random_scene(2, 6, k33, random), {{0, 1, 2}, {1, 4, 5}});
}

TEST_CASE("in a given frame an orientation selects a side") {
  for (const int sign : {1, -1}) {
    Problem problem(2);
    problem.points("a", "b", "c").distance("a", "c", 4).distance("b", "c", 5);
    problem.fix("a", {0, 0}).fix("b", {3, 0}).orientation({"a", "b", "c"}, sign);
    for (const auto& [strategy, options] : complex_strategies) {
      const Answer answer = solve(Scene(problem), strategy, options, {.certify = true});
      CAPTURE(strategy, answer.reason);
      CHECK(answer.failed_checks.empty());
      REQUIRE(answer.solutions.size() == 2);
      CHECK(answer.counts.complex_up_to_reflection == 2U);
      CHECK(answer.counts.real_up_to_reflection == 1U);
      CHECK(answer.counts.not_as_stated == 1U);
      REQUIRE(answer.solutions[0].is_as_stated());
      CHECK(answer.solutions[0].point("c").isApprox(Eigen::Vector2d(0, 4 * sign), 1e-12));
      CHECK_FALSE(answer.solutions[1].is_as_stated());
    }
  }
}

TEST_CASE("all strategies label what they find of an oriented scene") {
  RandomNumbers random(54);
  const std::vector<Points> of{{0, 1, 2, 3}};
  const ProblemStatement problem = random_scene(3, 5, all_pairs({0, 1, 2, 3, 4}, {{3, 4}}), random);
  for (const unsigned signs : {0U, 1U}) {
    const ProblemStatement stated = oriented(problem, of, signs);
    for (const auto& [strategy, options] : complex_strategies) {
      const Answer answer = answer_of(stated, strategy, false, options);
      CAPTURE(strategy, answer.reason);
      CHECK(answer.failed_checks.empty());
      CHECK(answer.solutions.size() == 4);
      check_labels(answer, of, signs);
    }
    const Answer started = answer_of(stated, "newton-multistart", false);
    CHECK(started.solutions.size() == 4);
    CHECK(started.counts.not_as_stated == 2U);
    CHECK_FALSE(started.counts.real_up_to_reflection);
  }
}

TEST_CASE("the first solution on S is the first as stated") {
  // S passes both sides of c, which the lengths allow; the triangle starts on one of them.
  for (const int sign : {1, -1}) {
    Problem problem(2);
    problem.points("a", "b", "c").distance("a", "b", 3).distance("a", "c", 4).distance("b", "c", 5);
    problem.orientation({"a", "b", "c"}, sign);
    problem.sketch("a", {0, 0}).sketch("b", {3, 0}).sketch("c", {1, 4});
    for (const char* until : {"first", "closed"}) {
      const Answer answer = solve(Scene(problem), "full-space", {{"until", until}});
      CAPTURE(sign, until, answer.reason);
      CHECK(answer.status == RunStatus::complete);
      CHECK(answer.failed_checks.empty());
      REQUIRE_FALSE(answer.solutions.empty());
      REQUIRE(answer.solutions[0].is_as_stated());
      CHECK(answer.solutions[0].point("c").isApprox(Eigen::Vector2d(0, 4 * sign), 1e-9));
      if (answer.claim == Claim::some_real) {
        CHECK(answer.crossings.back().solution == 0);
        CHECK(answer.counts.not_as_stated == (sign > 0 ? 0U : 1U));
      } else {
        CHECK(answer.claim == Claim::on_path);
        CHECK(answer.counts.on_path == 1U);
        CHECK(answer.counts.not_as_stated == 1U);
      }
    }
  }
}

TEST_CASE("a flat solution has no side, and says so") {
  Problem problem(2);
  problem.points("a", "b", "c").distance("a", "b", 2).distance("a", "c", 1).distance("b", "c", 1);
  problem.orientation({"a", "b", "c"}, 1);
  const Answer answer = solve(Scene(problem), "monodromy", {}, {.certify = true});
  REQUIRE(answer.solutions.size() == 1);
  CHECK(answer.solutions[0].multiplicity == 2);
  CHECK(answer.solutions[0].signs.standing == Standing::undecided);
  CHECK(answer.solutions[0].signs.relations == std::vector{0});
  CHECK(answer.counts.real_up_to_reflection == 0U);
  CHECK(answer.counts.undecided == 1U);
  CHECK(answer.counts.not_as_stated == 0U);
}

TEST_CASE("a certificate tells a side that doubles leave undecided") {
  // a = (0, 0), b = (2, 0), c = (0, 1) and d = (1, 1e-11) or (-1, 1e-11), and mirror images.
  Problem problem(2);
  problem.points("a", "b", "c", "d").distance("a", "b", 2).distance("a", "c", 1);
  problem.squared_distance("b", "c", 5).squared_distance("a", "d", "1.0000000000000000000001");
  problem.squared_distance("c", "d", "1.9999999999800000000001").orientation({"a", "b", "d"}, 1);
  const Answer found = solve(Scene(problem), "monodromy");
  CHECK(found.counts.undecided == 4U);
  CHECK(found.counts.real_up_to_reflection == 0U);
  const Answer proven = solve(Scene(problem), "monodromy", {}, {.certify = true});
  CHECK(proven.failed_checks.empty());
  CHECK(proven.counts.undecided == 0U);
  CHECK(proven.counts.real_up_to_reflection == 2U);
  CHECK(proven.counts.not_as_stated == 2U);
  REQUIRE(proven.proofs);
  CHECK(proven.proofs->real == 2);
  for (const AssessedSolution& solution : proven.solutions)
    CHECK(solution.is_as_stated() == (solution.point("c").y() > 0));
}

TEST_CASE("a segment of free length that points the other way is at another angle than is stated") {
  for (const double degrees : {50.0, 130.0}) {
    const ProblemStatement problem = samples::point_at_an_angle(degrees);
    for (const char* strategy : {"monodromy", "polyhedral"}) {
      const Answer answer = answer_of(problem, strategy);
      CAPTURE(degrees, strategy, answer.reason);
      CHECK(answer.failed_checks.empty());
      CHECK(answer.counts.complex_up_to_reflection == 4U);
      CHECK(answer.counts.real_up_to_reflection == 2U);
      CHECK(answer.counts.not_as_stated == 2U);
      CHECK(answer.counts.certified == 4U);
      REQUIRE(answer.solutions.size() == 4);
      for (int i = 0; i < 4; ++i) {
        const AssessedSolution& solution = answer.solutions[static_cast<std::size_t>(i)];
        const Eigen::Vector2d c = solution.point("c"), a = solution.point("a");
        const double angle = std::acos(c.normalized().dot(a)) * 180 / std::numbers::pi;
        CHECK(angle == Approx(i < 2 ? degrees : 180 - degrees));
        CHECK(solution.is_as_stated() == (i < 2));
      }
    }
  }
}
