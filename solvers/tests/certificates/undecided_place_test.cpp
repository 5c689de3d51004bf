/// Places whose solutions are known in closed form.

#include "solvers/certificates/undecided_place.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "solvers/tests/sample_forms.hpp"

using namespace gcs;

namespace {

/// As a box as subdivision leaves it.
constexpr double finest = 0x1p-36;

/// x² = square and y² = 1, at a place next to (0, 1).
std::optional<std::vector<CountedSolution>> at_pole(const std::string& square, const SignMasks& mirror,
                                                    double radius = finest) {
  const QuadraticSystem system{
      2, {{{{unknown(0), unknown(0)}}, decimal(square)}, {{{unknown(1), unknown(1)}}, exactly(1)}}, mirror};
  return real_solutions_in(system, {Eigen::Vector2d(finest / 3, 1), Eigen::Vector2d::Constant(radius)}, {});
}

/// x − 1
LinearForm beyond_one() { return unknown(0, 1, -1); }

/// u³ = square·u by y = u² with u = x − 1: u is 0 or ±√square.
QuadraticSystem three_in_a_line(double square) {
  return {2,
          {{{{beyond_one(), unknown(1, 1, -square)}}, {}},
           {{{beyond_one(), beyond_one()}, {unknown(1, -1), number(1)}}, {}}},
          {-1, -1}};
}

/// u² = square and 2uy − y² = other with u = x − 1: for the right sides 0 the origin of u and y four times.
QuadraticSystem crossing_conics(double square, double other) {
  const LinearForm twice = unknown(0, 2, -2);
  return {2,
          {{{{beyond_one(), beyond_one()}}, exactly(square)},
           {{{twice, unknown(1)}, {unknown(1, -1), unknown(1)}}, exactly(other)}},
          {-1, -1}};
}

Box about_one(double radius) { return {Eigen::Vector2d(1, 0), Eigen::Vector2d::Constant(radius)}; }

}  // namespace

TEST_CASE("all real solutions of a place are found where they count for all of it") {
  const SignMasks none{-1, -1}, first{0, -1};
  for (const std::string square : {"1e-22", "1e-26", "1e-36"}) {
    const auto both = at_pole(square, none), one = at_pole(square, first);
    INFO(square);
    REQUIRE(both);
    REQUIRE(both->size() == 2);
    const double x = std::sqrt(std::stod(square));
    for (const auto& [box, unique, multiplicity] : *both) {
      CHECK(std::abs(std::abs(box.mid[0]) - x) <= 1e-15 * x);
      CHECK(box.radius[0] <= 1e-15 * x);
      CHECK(unique >= 0);
      CHECK(multiplicity == 1);
    }
    CHECK((*both)[0].box.mid[0] * (*both)[1].box.mid[0] < 0);
    REQUIRE(one);  // mirror images of each other
    CHECK(one->size() == 1);
    const auto complex = at_pole("-" + square, none);
    REQUIRE(complex);
    CHECK(complex->empty());
  }
}

TEST_CASE("a multiple solution in fractions is one, and so many classes as are no mirror images") {
  for (const auto& [mirror, multiplicity] : {std::pair{SignMasks{-1, -1}, 2}, {SignMasks{0, -1}, 1}}) {
    const auto found = at_pole("0", mirror);
    REQUIRE(found);
    REQUIRE(found->size() == 1);
    CHECK((*found)[0].multiplicity == multiplicity);
    CHECK(std::abs((*found)[0].box.mid[0]) <= (*found)[0].box.radius[0]);
  }
  const auto four = real_solutions_in(crossing_conics(0, 0), about_one(1e-6), {});
  REQUIRE(four);
  REQUIRE(four->size() == 1);
  CHECK((*four)[0].multiplicity == 4);
}

TEST_CASE("three in a line are found, and those that are not real are left out") {
  for (const double square : {0x1p-60, 0x1p-70}) {
    const auto three = real_solutions_in(three_in_a_line(square), about_one(finest), {});
    REQUIRE(three);
    CHECK(three->size() == 3);
    const auto one = real_solutions_in(three_in_a_line(-square), about_one(finest), {});
    REQUIRE(one);
    REQUIRE(one->size() == 1);
    CHECK(std::abs((*one)[0].box.mid[0] - 1) <= (*one)[0].box.radius[0]);
  }
  const auto triple = real_solutions_in(three_in_a_line(0), about_one(1e-5), {});
  REQUIRE(triple);
  REQUIRE(triple->size() == 1);
  CHECK((*triple)[0].multiplicity == 3);
}

TEST_CASE("nothing is said of a place that holds more than is found or counted") {
  CHECK_FALSE(at_pole("1e-26", {-1, -1}, 2.5));  // y = −1 too
  CHECK_FALSE(at_pole("0.25", {-1, -1}));        // no solution is near
  // A line of solutions: (x − 1)² = 0 twice.
  const QuadraticSystem curve{
      2, {{{{beyond_one(), beyond_one()}}, {}}, {{{unknown(0, 3, -3), beyond_one()}}, {}}}, {-1, -1}};
  CHECK_FALSE(real_solutions_in(curve, about_one(finest), {}));
  std::stop_source stopped;
  stopped.request_stop();
  CHECK_FALSE(real_solutions_in(crossing_conics(0x1p-60, 0x1p-61), about_one(finest), stopped.get_token()));
}

TEST_CASE("boxes are of one place where they or their mirror images are near") {
  const auto at = [](double x, double y) {
    return Box{Eigen::Vector2d(x, y), Eigen::Vector2d::Constant(1e-11)};
  };
  const std::vector<Box> boxes{at(1, 2), at(1 + 1e-10, -2), at(1, 2 - 1e-9), at(-1, 2), at(1, 2.5)};
  const auto places = undecided_places(boxes, {-1, 0}, 1e-6);
  REQUIRE(places.size() == 3);
  CHECK(places[0].members == std::vector<std::size_t>{0, 1, 2});
  CHECK(places[1].members == std::vector<std::size_t>{3});
  for (const auto& [x, y] : {std::pair{1 + 1e-10, 2.0}, {1.0, 2 - 1e-9}}) {
    const Eigen::Vector2d apart = (Eigen::Vector2d(x, y) - places[0].hull.mid).cwiseAbs();
    CHECK(((apart + Eigen::Vector2d::Constant(1e-11)).array() <= places[0].hull.radius.array()).all());
  }
  CHECK(places[0].hull.radius.maxCoeff() <= 1.1e-9);
}
