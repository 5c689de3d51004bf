/// Clusters whose members are known in closed form.

#include "solvers/certificates/ball_cluster.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/tests/sample_forms.hpp"

using namespace gcs;
using Point = std::vector<std::complex<double>>;

namespace {

constexpr slong bits = 128;

/// x² + y² = 1 and y = height: x = ±√(1 − height²).
BallKrawczyk chord(const std::string& height) {
  return {{2,
           {{{{unknown(0), unknown(0)}, {unknown(1), unknown(1)}}, exactly(1)},
            {{{unknown(1), number(1)}}, decimal(height)}},
           {-1, -1}},
          bits};
}

/// x² = square and 2xy − y² = other: for the right sides 0 the origin four times.
BallKrawczyk conics(double square, double other, slong precision = bits) {
  return {{2,
           {{{{unknown(0), unknown(0)}}, exactly(square)},
            {{{unknown(0, 2), unknown(1)}, {unknown(1, -1), unknown(1)}}, exactly(other)}},
           {-1, -1}},
          precision};
}

/// x^power = value, with the powers in between as unknowns: of the origin a curve along which the others grow.
BallKrawczyk pure_power(int power, double value, slong precision = bits) {
  QuadraticSystem system;
  system.unknowns = power - 1;
  const auto times_x = [](int i) { return FormProduct{unknown(0), unknown(i)}; };
  for (int i = 1; i < system.unknowns; ++i)
    system.equations.push_back({{times_x(i - 1), {unknown(i, -1), number(1)}}, {}});
  system.equations.push_back({{times_x(system.unknowns - 1)}, exactly(value)});
  system.mirror = SignMasks(std::vector<SignMask>(static_cast<std::size_t>(system.unknowns), 0));
  return {system, precision};
}

}  // namespace

TEST_CASE("a tangent chord is a cluster of two, about as narrow as the point's error") {
  for (const double error : {0.0, 1e-15, 1e-9, 1e-5}) {
    const auto cluster = prove_cluster(chord("1"), {{error, 0}, {1 + error * error, 0}});
    REQUIRE(cluster);
    CHECK(cluster->solutions == 2);
    // It holds (0, 1).
    CHECK(cluster->radius[0] >= error);
    CHECK(cluster->radius[0] <= 100 * std::max(error, 1e-15));
    CHECK(cluster->radius[1] >= error * error);
  }
}

TEST_CASE("two solutions close together are a cluster that holds both") {
  for (const int digits : {6, 10, 16, 20}) {
    const std::string height = "0." + std::string(static_cast<std::size_t>(digits), '9');
    const auto cluster = prove_cluster(chord(height), {{0, 0}, {1, 0}});
    REQUIRE(cluster);
    CHECK(cluster->solutions == 2);
    const double half = std::sqrt(2 * std::pow(10.0, -digits));  // to a relative 10^−digits
    CHECK(cluster->radius[0] >= 0.999 * half);
    CHECK(cluster->radius[0] <= 10 * half);
  }
}

TEST_CASE("two conics without a common tangent meet in a cluster of four") {
  // x = ±√square, y = x ± √(square − other).
  for (const auto& [square, other] : {std::pair(0.0, 0.0), {1e-12, 0.0}, {0.0, 1e-12}, {1e-12, 3e-12}}) {
    const auto cluster = prove_cluster(conics(square, other), {{1e-15, 0}, {-1e-15, 0}});
    INFO("right sides " << square << " and " << other);
    REQUIRE(cluster);
    CHECK(cluster->solutions == 4);
    const double reach = std::sqrt(square) + std::sqrt(std::abs(square - other));
    CHECK(cluster->radius[1] >= reach);
    CHECK(cluster->radius[1] <= 100 * std::max(reach, 1e-15));
  }
}

TEST_CASE("any number up to eight along a curve are a cluster that holds them all") {
  for (int power = 2; power <= 8; ++power)
    for (const double value : {0.0, 1e-20, 1e-12}) {
      INFO(power << " solutions, x^" << power << " = " << value);
      const BallKrawczyk system = pure_power(power, value);
      const auto cluster =
          prove_cluster(system, Point(static_cast<std::size_t>(system.unknowns()), std::complex(1e-15, 0.0)));
      REQUIRE(cluster);
      CHECK(cluster->solutions == power);
      const double reach = std::pow(value, 1.0 / power);
      CHECK(cluster->radius[0] >= reach);
      const double rounding = std::ldexp(1.0, static_cast<int>(-bits) / power);  // x whose power is 2^−bits
      CHECK(cluster->radius[0] <= 100 * std::max({reach, 1e-14, rounding}));
    }
  CHECK_FALSE(prove_cluster(pure_power(9, 0), Point(8)));
}

TEST_CASE("folds that have nothing to do with each other are a cluster of all their solutions") {
  for (int folds = 1; folds <= 7; ++folds) {
    // (x_1 − x_2/2 + x_3 …)² = 1e-20·i, up to x_i: no unknown is a fold's own.
    QuadraticSystem system;
    system.unknowns = folds;
    LinearForm sum;
    for (int i = 0; i < folds; ++i) {
      sum.terms.push_back({i, exactly(i % 2 == 0 ? 1 : -0.5)});
      system.equations.push_back({{{sum, sum}}, exactly(1e-20 * i)});
    }
    system.mirror = SignMasks(std::vector<SignMask>(static_cast<std::size_t>(folds), 0));
    const auto cluster = prove_cluster({system, bits}, Point(static_cast<std::size_t>(folds)));
    INFO(folds);
    REQUIRE(cluster.has_value() == (folds <= 6));
    if (cluster) CHECK(cluster->solutions == 1 << folds);
  }
}

TEST_CASE("the point at which solutions meet is found to many digits, and none where they do not meet") {
  for (int power = 2; power <= 8; ++power) {
    INFO(power);
    const Point next_to(static_cast<std::size_t>(power - 1), std::complex(1e-7, -1e-8));
    const auto meeting = meeting_point(pure_power(power, 0, 256), next_to, power);
    REQUIRE(meeting);
    CHECK(magnitude((*meeting)(0, 0)) <= std::ldexp(1.0, -200 / power));
    CHECK_FALSE(meeting_point(pure_power(power, 1e-12, 256), next_to, power));
    CHECK_FALSE(meeting_point(pure_power(power, 0, 256), next_to, power + 1));
  }
  CHECK_FALSE(meeting_point(conics(0, 0, 256), {{1e-9, 0}, {0, 0}}, 4));  // the Jacobian loses two
}

TEST_CASE("a double and a simple solution are a cluster of three where they are near each other") {
  // x² (x − apart) = 0 with y = x².
  for (const auto& [apart, solutions] : {std::pair(1e-9, 3), {1e-2, 2}}) {
    const BallKrawczyk system({2,
                               {{{{unknown(0, 1, -apart), unknown(1)}}, {}},
                                {{{unknown(1), number(1)}, {unknown(0, -1), unknown(0)}}, {}}},
                               {0, 0}},
                              bits);
    const auto cluster = prove_cluster(system, {{1e-8, 0}, {0, 0}});
    REQUIRE(cluster);
    CHECK(cluster->solutions == solutions);
    CHECK((cluster->radius[0] >= apart) == (solutions == 3));
  }
}

TEST_CASE("numbers that doubles do not hold are bounded from either side") {
  Ball ball;
  acb_one(ball);
  for (const slong exponent : {-100000, -1100, -1000, 0, 1000, 1100, 100000}) {
    acb_mul_2exp_si(ball, ball, exponent);
    CHECK(least_magnitude(ball) <= std::pow(2.0, static_cast<double>(exponent)));
    CHECK(magnitude(ball) >= std::pow(2.0, static_cast<double>(exponent)));
    acb_mul_2exp_si(ball, ball, -exponent);
  }
}

TEST_CASE("no cluster is proven at a simple solution, off all of them, or where forms have a common zero") {
  CHECK_FALSE(prove_cluster(chord("0.6"), {{0.8, 0}, {0.6, 0}}));
  CHECK_FALSE(prove_cluster(chord("1"), {{0.2, 0}, {0.9, 0}}));
  // x² = y² and xy = x²: a line of solutions, x = y.
  const BallKrawczyk line({2,
                           {{{{unknown(0), unknown(0)}, {unknown(1, -1), unknown(1)}}, {}},
                            {{{unknown(0), unknown(1)}, {unknown(0, -1), unknown(0)}}, {}}},
                           {-1, -1}},
                          bits);
  CHECK_FALSE(prove_cluster(line, {{0, 0}, {0, 0}}));
  // xy = 0 and x² = yz, z = y²: the origin five times, and no two quadratic forms say so.
  const BallKrawczyk fivefold({3,
                               {{{{unknown(0), unknown(1)}}, {}},
                                {{{unknown(0), unknown(0)}, {unknown(1, -1), unknown(2)}}, {}},
                                {{{unknown(2), number(1)}, {unknown(1, -1), unknown(1)}}, {}}},
                               {0, 0, 0}},
                              bits);
  CHECK_FALSE(prove_cluster(fivefold, {{0, 0}, {0, 0}, {0, 0}}));
}

TEST_CASE("a polydisc about a point that no double is holds the point, and as many as this stands for") {
  // (3x − 1)² = 0, and the same beside a simple zero y.
  const LinearForm factor = unknown(0, 3, -1);
  const BallKrawczyk one(square_system({{{{factor, factor}}, {}}}), bits);
  const BallKrawczyk two(
      square_system({{{{factor, factor}}, {}}, {{{unknown(1), number(1)}, {unknown(0), unknown(0)}}, {}}}),
      bits);
  BallMatrix x(1, 1), xy(2, 1);
  acb_set_si(x(0, 0), 1);
  acb_div_si(x(0, 0), x(0, 0), 3, bits);
  acb_set(xy(0, 0), x(0, 0));
  acb_mul(xy(1, 0), x(0, 0), x(0, 0), bits);
  acb_neg(xy(1, 0), xy(1, 0));
  CHECK(solutions_about(one, x, {0}) == 2);
  CHECK(solutions_about(two, xy, {0, 0}) == 2);
  CHECK(solutions_about(two, BallMatrix(2, 1), {0, 0}) != 2);
}
