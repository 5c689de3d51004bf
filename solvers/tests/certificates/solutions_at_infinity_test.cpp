/// Solutions at infinity of octahedra. Each edge is in one of three equators, closed walks around a pair of opposite
/// vertices: for each choice of signs with which the lengths of an equator sum to 0, one of the 8 classes is at infinity.
/// There the equator lies in an isotropic plane, which gives the two diagonals of its corners; the one vertex of the pair
/// that stays is at given distances from it, and one class of figures has these distances.

#include "solvers/certificates/solutions_at_infinity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <numeric>

#include "solvers/solving/solve.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// Hundredths; point 2i is opposite to 2i + 1.
struct Equators {
  std::array<std::array<int, 4>, 3> around{};  ///< from 0 to 2, 1, 3 of the other four points and back

  int escaping() const {
    int count = 0;
    for (const auto& [a, b, c, d] : around) count += (a + b == c + d) + (a + c == b + d) + (a + d == b + c);
    return count;
  }
};

/// With so many equators whose lengths sum to 0. All triangles can close.
Equators random_equators(int escaping, RandomNumbers& random) {
  Equators result;
  do {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = 95 + random.index(10), b = 95 + random.index(10), c = 95 + random.index(10);
      const int off = static_cast<int>(i) < escaping ? 0 : 1 + random.index(9);
      result.around[i] = {a, b, c, a - b + c + off};
    }
  } while (result.escaping() != escaping);
  return result;
}

using EdgeLengths = std::vector<std::pair<std::array<int, 2>, int>>;

EdgeLengths edges_of(const Equators& lengths, const std::array<int, 6>& points) {
  EdgeLengths edges;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t next = 2 * ((i + 1) % 3), last = 2 * ((i + 2) % 3);
    const std::array<int, 4> corners{points[next], points[last], points[next + 1], points[last + 1]};
    for (std::size_t k = 0; k < 4; ++k)
      edges.push_back({{corners[k], corners[(k + 1) % 4]}, lengths.around[i][k]});
  }
  return edges;
}

/// `length`: of so many hundredths, as a decimal; or its square.
template <class Text>
ProblemStatement shuffled(const EdgeLengths& edges, const Text& length, bool is_squared,
                          RandomNumbers& random) {
  ProblemStatement problem;
  int points = 0;
  for (const auto& [ends, hundredths] : edges) points = std::max({points, ends[0] + 1, ends[1] + 1});
  std::vector<int> numbers(static_cast<std::size_t>(points));
  std::iota(numbers.begin(), numbers.end(), 0);
  for (std::size_t i = numbers.size() - 1; i > 0; --i)
    std::swap(numbers[i], numbers[static_cast<std::size_t>(random.index(static_cast<int>(i) + 1))]);
  for (int i = 0; i < points; ++i) problem.points.push_back(fmt::format("p{}", i));
  for (const auto& [ends, hundredths] : edges) {
    const std::string text = length(hundredths);
    problem.constraints.push_back(
        {fmt::format("e{}", problem.constraints.size()),
         {numbers[static_cast<std::size_t>(ends[0])], numbers[static_cast<std::size_t>(ends[1])]},
         {std::stod(text), text},
         is_squared});
  }
  problem.reference = Reference{numbers[0], numbers[2], numbers[4]};
  return problem;
}

std::string in_hundredths(int hundredths) { return fmt::format("{}e-2", hundredths); }

Answer certified(const ProblemStatement& problem, const OptionMap& options = {}) {
  return gcs::solve(Scene(problem), "monodromy", options, {.certify = true});
}

void check_proven(const Answer& answer, std::uint64_t classes, std::uint64_t at_infinity) {
  CHECK(answer.status == RunStatus::complete);
  CHECK(answer.failed_checks.empty());
  REQUIRE(answer.proofs);
  CHECK(answer.proofs->classes == classes);
  CHECK(answer.proofs->at_infinity == at_infinity);
  CHECK(answer.proofs->why_not_at_infinity.empty());
  CHECK(answer.proofs->are_complete());
  CHECK(answer.proofs->decide_real());
}

constexpr std::array<int, 6> first_points{0, 1, 2, 3, 4, 5};

/// With one escaping class, but for a length that is longer by 10^−exponent.
Answer all_but_escaping(int exponent) {
  RandomNumbers random(35);
  const Equators lengths = random_equators(1, random);
  ProblemStatement problem = shuffled(edges_of(lengths, first_points), in_hundredths, false, random);
  const std::string zeros(static_cast<std::size_t>(exponent - 3), '0');
  problem.constraints.front().given.text = fmt::format("{}.{}1e-2", lengths.around[0][0], zeros);
  return certified(problem);
}

}  // namespace

TEST_CASE("an octahedron has a class less for each equator whose lengths sum to 0") {
  RandomNumbers random(31);
  for (const int escaping : {1, 2, 3, 1, 2, 3}) {
    const Equators lengths = random_equators(escaping, random);
    CAPTURE(escaping);
    const auto missing = static_cast<std::uint64_t>(escaping);
    check_proven(certified(shuffled(edges_of(lengths, first_points), in_hundredths, false, random)),
                 8 - missing, missing);
  }
}

TEST_CASE("lengths that are square roots sum to 0 as well") {
  RandomNumbers random(32);
  const Equators lengths = random_equators(2, random);
  const auto twice_squared = [](int hundredths) { return fmt::format("{}e3", 2 * hundredths * hundredths); };
  check_proven(certified(shuffled(edges_of(lengths, first_points), twice_squared, true, random)), 6, 2);
}

TEST_CASE("points that hang on an escaping one escape with it") {
  RandomNumbers random(33);
  EdgeLengths edges = edges_of(random_equators(1, random), first_points);
  for (const int point : {0, 2, 4}) edges.push_back({{6, point}, 95 + random.index(10)});
  for (const int point : {1, 2, 4}) edges.push_back({{7, point}, 95 + random.index(10)});
  check_proven(certified(shuffled(edges, in_hundredths, false, random), {{"reduce", "off"}}), 28, 4);
}

TEST_CASE("of two octahedra one may be at infinity, or both") {
  RandomNumbers random(34);
  const Equators first = random_equators(1, random);
  Equators other = random_equators(1, random);
  // They have the triangle of the even points in common: the first edge of each equator.
  for (std::size_t i = 0; i < 3; ++i) {
    const int longer = first.around[i][0] - other.around[i][0];
    other.around[i][0] += longer;
    other.around[i][1] += longer;
  }
  REQUIRE(other.escaping() == 1);
  EdgeLengths edges = edges_of(first, first_points);
  for (const auto& edge : edges_of(other, {0, 6, 2, 7, 4, 8}))
    if (edge.first[0] > 4 || edge.first[1] > 4) edges.push_back(edge);
  check_proven(certified(shuffled(edges, in_hundredths, false, random), {{"reduce", "off"}}), 98, 30);
}

TEST_CASE("a solution far away is proven to be there, and never to be at infinity") {
  const Answer far = all_but_escaping(22);
  REQUIRE(far.proofs);
  CHECK(far.proofs->classes == 8);
  CHECK(far.proofs->are_complete());
  const Answer answer = all_but_escaping(60);
  REQUIRE(answer.proofs);
  CHECK(answer.counts.at_infinity == 1u);  // balls do not tell, of so many bits
  CHECK(answer.proofs->classes == 7);
  CHECK(answer.proofs->at_infinity == 0);
  CHECK(!answer.proofs->why_not_at_infinity.empty());
  CHECK(!answer.proofs->are_complete());
}
