#include "solvers/octahedron/exact_squares.hpp"

#include <arb.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "solvers/octahedron/exact_determinants.hpp"
#include "solvers/tests/random_numbers.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using gcs::samples::RandomNumbers;

namespace {

/// With 400 bits: a sum of four roots of numbers below 10 that is not 0 is above 1e-30.
bool is_zero_in_balls(const std::array<long, 4>& squares, const std::array<int, 4>& signs) {
  arb_t sum, root;
  arb_init(sum);
  arb_init(root);
  for (std::size_t i = 0; i < 4; ++i) {
    arb_sqrt_ui(root, static_cast<ulong>(squares[i]), 400);
    arb_addmul_si(sum, root, signs[i], 400);
  }
  const bool holds_zero = arb_contains_zero(sum);
  arb_clear(sum);
  arb_clear(root);
  return holds_zero;
}

Octahedron core_of(const Scene& scene) {
  return *find_octahedron(scene.problem(), reduce_to_core(scene.problem(), {}));
}

/// The sample octahedron with other points; lengths are doubles.
ProblemStatement octahedron_of(const Eigen::Matrix3Xd& points) {
  ProblemStatement problem = samples::octahedron();
  for (DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = constraint.between;
    constraint.given = {(points.col(a) - points.col(b)).norm(), ""};
    constraint.is_squared = false;
  }
  problem.sketch.reset();
  return problem;
}

/// Bricard's first type, of a half turn about the z-axis, and his second, of a reflection in z = 0 that
/// exchanges two pairs and keeps the third pair's points.
Eigen::Matrix3Xd flexible(const Octahedron& octahedron, bool turns, RandomNumbers& numbers) {
  Eigen::Matrix3Xd points(3, 6);
  for (int i = 0; i < 3; ++i) {
    const auto [a, a2] = octahedron.pair[static_cast<std::size_t>(i)];
    const Eigen::Vector3d place(numbers.uniform(-1, 1), numbers.uniform(-1, 1), numbers.uniform(-1, 1));
    points.col(a) = place;
    if (turns) {
      points.col(a2) << -place[0], -place[1], place[2];
    } else if (i < 2) {
      points.col(a2) << place[0], place[1], -place[2];
    } else {
      points.col(a) << place[0], place[1], 0;
      points.col(a2) << numbers.uniform(-1, 1), numbers.uniform(-1, 1), 0;
    }
  }
  return points;
}

}  // namespace

TEST_CASE("signed sums of square roots vanish exactly when balls of 400 bits hold zero") {
  RandomNumbers numbers(1);
  int zeros = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<long, 4> squares{};
    std::array<int, 4> signs{};
    for (std::size_t k = 0; k < 4; ++k) {
      squares[k] = static_cast<long>(numbers.uniform(1, 10));
      signs[k] = numbers.uniform(-1, 1) < 0 ? -1 : 1;
    }
    const RootSum sum({squares[0], squares[1], squares[2], squares[3]});
    CHECK(sum.vanishes(signs) == is_zero_in_balls(squares, signs));
    zeros += sum.vanishes(signs) ? 1 : 0;
  }
  CHECK(zeros > 0);
}

TEST_CASE("Bricard's octahedra of the first two types are proven to flex, others are not") {
  RandomNumbers numbers(2);
  for (const bool turns : {true, false})
    for (int i = 0; i < 10; ++i) {
      const Octahedron octahedron = core_of(Scene(samples::octahedron()));
      ProblemStatement problem = octahedron_of(flexible(octahedron, turns, numbers));
      const Scene scene = Scene::unchecked(problem);
      CHECK(is_proven_to_flex(scene, core_of(scene)));
      problem.constraints[static_cast<std::size_t>(i)].given.value *= 1.25;
      const Scene other = Scene::unchecked(problem);
      CHECK_FALSE(is_proven_to_flex(other, core_of(other)));
    }
}

TEST_CASE("walks are stretched by the decimals of the file") {
  ProblemStatement problem = samples::octahedron();
  for (DistanceConstraint& constraint : problem.constraints) constraint.given = {1, "1"};
  const auto walks = [](const ProblemStatement& given) {
    const Scene scene = Scene::unchecked(given);
    return stretched_walks(scene, core_of(scene));
  };
  // Of each of three walks with sides 1 three choices of signs but for a common one.
  CHECK(walks(problem) == 9);
  // 1.1 + 1 = 0.9 + 1.2 in decimals and not in doubles.
  const Octahedron octahedron = core_of(Scene::unchecked(problem));
  const auto [b, b2] = octahedron.pair[1];
  const auto [c, c2] = octahedron.pair[2];
  const std::array<std::array<int, 2>, 4> sides{{{b, c}, {c, b2}, {b2, c2}, {c2, b}}};
  const std::array<Decimal, 4> lengths{{{1.1, "1.1"}, {1, "1"}, {0.9, "0.9"}, {1.2, "1.2"}}};
  for (DistanceConstraint& constraint : problem.constraints)
    for (std::size_t i = 0; i < 4; ++i)
      if (std::minmax(constraint.between[0], constraint.between[1]) == std::minmax(sides[i][0], sides[i][1]))
        constraint.given = lengths[i];
  CHECK(walks(problem) == 7);
  for (DistanceConstraint& constraint : problem.constraints) constraint.given.text.clear();
  CHECK(walks(problem) == 6);
}
