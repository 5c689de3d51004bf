#include "harness/results/median_interval.hpp"

#include <catch2/catch.hpp>
#include <numeric>

using namespace gcs;

TEST_CASE("the median does not depend on the order of the measurements") {
  CHECK(median_interval({3, 1, 2}).median == 2);
  CHECK(median_interval({4, 1, 3, 2}).median == 2.5);
  CHECK(median_interval({5}).median == 5);
}

TEST_CASE("few measurements give their range and say what it is worth") {
  const MedianInterval interval = median_interval({3, 1, 2});
  CHECK(interval.low == 1);
  CHECK(interval.high == 3);
  CHECK(interval.confidence == Approx(0.75));
}

TEST_CASE("the interval is the narrowest that reaches 95 %") {
  std::vector<double> measurements(20);
  std::iota(measurements.begin(), measurements.end(), 1.0);
  const MedianInterval interval = median_interval(measurements);
  // Tables of the sign test: for n = 20 the 6th and the 15th value bound the median with 95.86 %.
  CHECK(interval.low == 6);
  CHECK(interval.high == 15);
  CHECK(interval.confidence == Approx(0.9586).margin(1e-4));
  CHECK(interval.relative_half_width() == Approx(4.5 / 10.5));
}

TEST_CASE("thousands of measurements do not underflow") {
  const MedianInterval interval = median_interval(std::vector<double>(5000, 2.0));
  CHECK(interval.confidence == Approx(0.95).margin(0.01));
  CHECK(interval.relative_half_width() == 0);
}
