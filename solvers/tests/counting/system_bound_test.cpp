/// Bounds of square systems of quadrics against numbers of solutions that are known.

#include "solvers/counting/system_bound.hpp"

#include <catch2/catch.hpp>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "solvers/reading/instance_parser.hpp"
#include "solvers/solving/solve.hpp"
#include "solvers/strategies/monodromy.hpp"
#include "solvers/tests/elements/general_samples.hpp"
#include "solvers/tests/sample_forms.hpp"

using namespace gcs;

namespace {

/// (A − λ)x = 0 and b·x = 1, unknowns x, then λ: as many solutions as A has eigenvalues.
QuadraticSystem eigenvectors(int n) {
  std::vector<QuadraticEquation> equations;
  for (int i = 0; i < n; ++i) {
    QuadraticEquation row{{{unknown(i, -1), unknown(n)}}, {}};
    for (int j = 0; j < n; ++j) row.products.push_back({unknown(j, 2 + i * j), number(1)});
    equations.push_back(row);
  }
  QuadraticEquation length{{}, exactly(1)};
  for (int j = 0; j < n; ++j) length.products.push_back({unknown(j), number(j + 1)});
  equations.push_back(length);
  return square_system(std::move(equations));
}

/// x² = 2, and y² = 1 beside it or x·y = 0; y changes its sign in a mirror image.
QuadraticSystem mirrored(bool is_flat) {
  QuadraticSystem system =
      square_system({{{{unknown(0), unknown(0)}}, exactly(2)},
                     {{{unknown(1), unknown(is_flat ? 0 : 1)}}, exactly(is_flat ? 0 : 1)}});
  system.mirror = SignMasks(std::vector<SignMask>{0, 1});
  return system;
}

ProblemStatement general_scene(const std::string& elements) {
  return parse_instance(R"({"format": "gcsbench-instance/2", "id": "scene", "title": "A scene", )" +
                        elements + "}")
      .problem;
}

Natural bound_of(const ProblemStatement& problem) {
  const Scene scene = Scene::unchecked(problem);
  return class_bound(SceneSystem(scene)).value();
}

void check_sharp(const ProblemStatement& problem, std::size_t count) {
  CHECK(bound_of(problem) == Natural(count));
  const Answer answer = solve(Scene(problem), Monodromy{.certify = true});
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.solutions.size() == count);
  CHECK(answer.proofs.value().meets_limit(count));
}

}  // namespace

TEST_CASE("an eigenvalue problem has as many solutions as the matrix has rows") {
  for (const int n : {2, 5, 40}) {
    std::vector<int> vector(static_cast<std::size_t>(n));
    std::iota(vector.begin(), vector.end(), 0);
    CHECK(system_bound(eigenvectors(n), {vector}) == Natural(static_cast<std::uint64_t>(n)));
  }
}

TEST_CASE("where counting in many groups takes too long a bound is Bézout's at most") {
  CHECK(system_bound(eigenvectors(40), {}).value() <= Natural::power_of_two(40));
}

TEST_CASE("the bounds of blocks that are solved one after the other are multiplied") {
  const QuadraticSystem roots = square_system({{{{unknown(1), unknown(1)}, {unknown(0), number(-1)}}, {}},
                                               {{{unknown(0), unknown(0)}}, exactly(2)},
                                               {{{unknown(2), unknown(1)}, {unknown(0), unknown(0)}}, {}}});
  CHECK(system_bound(roots, {{0, 1, 2}}) == Natural(4));
}

TEST_CASE("there is no bound where an equation has no unknown of its own") {
  CHECK_FALSE(system_bound(
      square_system({{{{unknown(0), unknown(0)}}, exactly(2)}, {{{unknown(0), unknown(0)}}, exactly(3)}}),
      {}));
}

TEST_CASE("mirror images divide a bound, and a regular solution that is its own mirror image does not") {
  CHECK(class_bound(mirrored(false), {}) == Natural(2));
  CHECK(class_bound(mirrored(true), {}) == Natural(2));
}

TEST_CASE("the bound of a scene's equations is met where each element has as many places as Bézout says") {
  // A plane through a tangent cone of three spheres; a flap on a hinge, held by a rod; a point on two lines and one side.
  check_sharp(general_scene(R"("dimension": 3, "points": ["a", "b", "c"], "planes": ["E"],
      "fixed": {"a": [0, 0, 0], "b": [3, 0, 0], "c": [1, 2, 0]}, "constraints": [
      {"type": "distance", "between": ["a", "E"], "length": 1}, {"type": "distance", "between": ["b", "E"], "length": 0.5},
      {"type": "distance", "between": ["c", "E"], "length": -0.7}])"),
              2);
  check_sharp(
      general_scene(
          R"("dimension": 3, "points": [], "bodies": {"wall": {"h": [0, 0, 0], "i": [0, 0, 2], "w": [2, 0, 1]},
      "flap": {"h": [0, 0, 0], "i": [0, 0, 2], "d": [1, 0, 1]}},
      "constraints": [{"type": "distance", "between": ["w", "d"], "length": 1.5}])"),
      2);
}

TEST_CASE("no scene has more solutions than the bound of its equations") {
  samples::RandomNumbers random(11);
  CHECK(bound_of(samples::random_platform(2, random)) >= Natural(6));
  CHECK(bound_of(samples::random_platform(3, random)) >= Natural(40));
  for (const int planes : {1, 2, 3})
    CHECK(bound_of(samples::random_octahedral(planes, random)) >= Natural(8));
}
