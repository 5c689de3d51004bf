#include "solvers/numeric/double_double.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>

#include "solvers/tests/quad.hpp"
#include "solvers/tests/random_numbers.hpp"

using gcs::DoubleDouble;
using gcs::samples::Quad;
using gcs::samples::RandomNumbers;

namespace {

constexpr int samples = 20'000;

Quad quad(const DoubleDouble& a) { return Quad(a.hi) + Quad(a.lo); }

/// A double of either sign with an exponent in [−range, range].
double random_double(RandomNumbers& random, int range) {
  return std::ldexp(random.sign() * random.uniform(1, 2), random.index(2 * range + 1) - range);
}

DoubleDouble random_double_double(RandomNumbers& random, int range) {
  const double hi = random_double(random, range);
  return gcs::two_sum(hi, hi * random.uniform(-1, 1) * 0x1p-53);
}

/// |computed − exact| in units of 2^−100·|exact|.
double error_units(const DoubleDouble& computed, Quad exact) {
  const Quad error = gcs::samples::magnitude(quad(computed) - exact);
  if (error == 0) return 0;
  return static_cast<double>(error / gcs::samples::magnitude(exact)) * 0x1p100;
}

bool normalised(const DoubleDouble& a) { return a.hi + a.lo == a.hi; }

}  // namespace

TEST_CASE("two_sum loses nothing of a sum of two doubles") {
  RandomNumbers random(1);
  int wrong = 0;
  for (int i = 0; i < samples; ++i) {
    // 113 bits hold the exact sum of doubles whose exponents differ by up to 60.
    const double a = random_double(random, 25);
    const double b = random_double(random, 25);
    const DoubleDouble sum = gcs::two_sum(a, b);
    if (quad(sum) != Quad(a) + Quad(b) || sum.hi != a + b || !normalised(sum)) ++wrong;
  }
  CHECK(wrong == 0);
  const DoubleDouble absorbed = gcs::two_sum(1e-300, 1e300);
  CHECK(absorbed.hi == 1e300);
  CHECK(absorbed.lo == 1e-300);
}

TEST_CASE("two_product loses nothing of a product of two doubles") {
  RandomNumbers random(2);
  int wrong = 0;
  for (int i = 0; i < samples; ++i) {
    const double a = random_double(random, 400);
    const double b = random_double(random, 400);
    const DoubleDouble product = gcs::two_product(a, b);
    if (quad(product) != Quad(a) * Quad(b) || product.hi != a * b || !normalised(product)) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("sums, differences and products of double-doubles are good to 2^-100") {
  RandomNumbers random(3);
  double worst = 0;
  int unnormalised = 0;
  for (int i = 0; i < samples; ++i) {
    const DoubleDouble a = random_double_double(random, 6);
    const DoubleDouble b = random_double_double(random, 6);
    for (const auto& [computed, exact] :
         {std::pair{a + b, quad(a) + quad(b)}, std::pair{a - b, quad(a) - quad(b)},
          std::pair{a * b, quad(a) * quad(b)}}) {
      worst = std::max(worst, error_units(computed, exact));
      if (!normalised(computed)) ++unnormalised;
    }
  }
  CHECK(worst <= 1);
  CHECK(unnormalised == 0);
}

TEST_CASE("a difference of nearly equal double-doubles keeps its last bits") {
  RandomNumbers random(4);
  double worst = 0;
  for (int i = 0; i < samples; ++i) {
    const DoubleDouble a = random_double_double(random, 3);
    DoubleDouble b = a;
    b.lo += random.uniform(-1, 1) * std::ldexp(a.hi, -53 - random.index(40));
    b = gcs::two_sum(b.hi, b.lo);
    // Each difference fits into 113 bits; a's own two parts may not.
    const Quad exact = (Quad(a.hi) - Quad(b.hi)) + (Quad(a.lo) - Quad(b.lo));
    worst = std::max(worst, error_units(a - b, exact));
  }
  CHECK(worst <= 1);
  const DoubleDouble x{1, 0x1p-60};
  CHECK((x - x).value() == 0);
}

TEST_CASE("the square root is good to 2^-98 and exact for squares") {
  RandomNumbers random(5);
  double worst = 0;
  int wrong_roots = 0;
  for (int i = 0; i < samples; ++i) {
    DoubleDouble a = random_double_double(random, 20);
    if (a.hi < 0) a = -a;
    const Quad root = quad(sqrt(a));
    const Quad error = gcs::samples::magnitude(root * root - quad(a)) / (2 * quad(a));
    worst = std::max(worst, static_cast<double>(error) * 0x1p98);

    const double b = std::abs(random_double(random, 20));
    const DoubleDouble exact = sqrt(gcs::two_product(b, b));
    if (exact.hi != b || exact.lo != 0) ++wrong_roots;
  }
  CHECK(worst <= 1);
  CHECK(wrong_roots == 0);
  CHECK(sqrt(DoubleDouble{}).value() == 0);
}

TEST_CASE("squared distances of integer points are the exact integers") {
  RandomNumbers random(6);
  int wrong = 0;
  for (int i = 0; i < samples; ++i) {
    Eigen::Vector3d a;
    Eigen::Vector3d b;
    Quad square = 0;
    for (int axis = 0; axis < 3; ++axis) {
      // Every partial sum is below 2^84 and fits into a double-double.
      a[axis] = std::floor(random.uniform(-0x1p40, 0x1p40));
      b[axis] = std::floor(random.uniform(-0x1p40, 0x1p40));
      square += (Quad(a[axis]) - Quad(b[axis])) * (Quad(a[axis]) - Quad(b[axis]));
    }
    if (quad(gcs::squared_distance(a, b, 3)) != square) ++wrong;
  }
  CHECK(wrong == 0);
}

TEST_CASE("the squared distance of close points far from the origin does not cancel") {
  const Eigen::Vector3d a(1e6, -3e5, 7e4);
  const Eigen::Vector3d b = a + Eigen::Vector3d(1e-9, 2e-9, -1e-9);
  Quad square = 0;
  for (int axis = 0; axis < 2; ++axis)
    square += (Quad(a[axis]) - Quad(b[axis])) * (Quad(a[axis]) - Quad(b[axis]));
  CHECK(error_units(gcs::squared_distance(a, b, 2), square) <= 1);
}
