/// Clusters whose members are known in closed form.

#include "solvers/certificates/ball_cluster.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace gcs;
using Point = std::vector<std::complex<double>>;

namespace {

constexpr slong bits = 128;

LinearForm unknown(int i, double factor = 1, double constant = 0) {
  return {{{i, exactly(factor)}}, exactly(constant)};
}

ExactNumber decimal(const std::string& text) {
  ExactNumber number;
  number.decimal = text;
  return number;
}

const LinearForm one{{}, exactly(1)};

/// x² + y² = 1 and y = height: x = ±√(1 − height²).
BallKrawczyk chord(const std::string& height) {
  return {{2,
           {{{{unknown(0), unknown(0)}, {unknown(1), unknown(1)}}, exactly(1)},
            {{{unknown(1), one}}, decimal(height)}},
           {-1, -1}},
          bits};
}

/// x² = square and 2xy − y² = other: for the right sides 0 the origin four times.
BallKrawczyk conics(double square, double other) {
  return {{2,
           {{{{unknown(0), unknown(0)}}, exactly(square)},
            {{{unknown(0, 2), unknown(1)}, {unknown(1, -1), unknown(1)}}, exactly(other)}},
           {-1, -1}},
          bits};
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

TEST_CASE("no cluster is proven at a simple solution, off all of them, or at a triple one") {
  CHECK_FALSE(prove_cluster(chord("0.6"), {{0.8, 0}, {0.6, 0}}));
  CHECK_FALSE(prove_cluster(chord("1"), {{0.2, 0}, {0.9, 0}}));
  // xy = 0 and y = x²: x³ = 0.
  const BallKrawczyk cubic(
      {2,
       {{{{unknown(0), unknown(1)}}, {}}, {{{unknown(1), one}, {unknown(0, -1), unknown(0)}}, {}}},
       {-1, -1}},
      bits);
  CHECK_FALSE(prove_cluster(cubic, {{0, 0}, {0, 0}}));
  // x² = y² and xy = x²: a line of solutions, x = y.
  const BallKrawczyk line({2,
                           {{{{unknown(0), unknown(0)}, {unknown(1, -1), unknown(1)}}, {}},
                            {{{unknown(0), unknown(1)}, {unknown(0, -1), unknown(0)}}, {}}},
                           {-1, -1}},
                          bits);
  CHECK_FALSE(prove_cluster(line, {{0, 0}, {0, 0}}));
}
