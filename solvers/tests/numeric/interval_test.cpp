/// Intervals hold the exact results of operations on their numbers.

#include "solvers/numeric/interval.hpp"

#include <catch2/catch.hpp>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;

namespace {

/// Whether low ≤ exact ≤ high, in double-double.
bool holds(const Interval& x, const DoubleDouble& exact) {
  return (exact - DoubleDouble{x.low, 0}).value() >= 0 && (DoubleDouble{x.high, 0} - exact).value() >= 0;
}

struct Sample {
  Interval interval;
  double inside;
};

/// Narrow ones down to a single number, of either sign or both, of sizes from 1e-9 to 1e9.
Sample sample(samples::RandomNumbers& random) {
  const double size = std::pow(10, random.uniform(-9, 9));
  const double x = random.uniform(-size, size);
  const double radius = random.index(3) == 0 ? 0 : size * std::pow(10, random.uniform(-17, 0.5));
  return {{x - radius, x + radius}, std::clamp(x + radius * random.uniform(-1, 1), x - radius, x + radius)};
}

}  // namespace

TEST_CASE("intervals hold the exact sums, products, squares, quotients and roots of their numbers") {
  samples::RandomNumbers random(1966);
  for (int i = 0; i < 20000; ++i) {
    const auto [x, a] = sample(random);
    const auto [y, b] = sample(random);
    const DoubleDouble exact_product = two_product(a, b);
    CHECK(holds(x + y, two_sum(a, b)));
    CHECK(holds(x - y, two_sum(a, -b)));
    CHECK(holds(x * y, exact_product));
    CHECK(holds(a * y, exact_product));
    CHECK(holds(square(x), two_product(a, a)));
    if (!y.contains_zero()) CHECK(holds(x / y, DoubleDouble{a, 0} / DoubleDouble{b, 0}));
    if (a >= 0) CHECK(holds(sqrt(x), sqrt(DoubleDouble{a, 0})));
  }
}

TEST_CASE("of single numbers the results of intervals are a few units in the last place wide") {
  samples::RandomNumbers random(1979);
  for (int i = 0; i < 1000; ++i) {
    const double a = random.uniform(1, 2), b = random.uniform(1, 2);
    for (const Interval& result :
         {exact_interval(a) + exact_interval(b), exact_interval(a) * exact_interval(b),
          exact_interval(a) / exact_interval(b), sqrt(exact_interval(a))})
      CHECK(result.width() <= 0x1p-48);
  }
}
