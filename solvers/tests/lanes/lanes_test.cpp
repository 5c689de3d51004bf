#include "solvers/lanes/lanes.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

using namespace gcs;
using portable_lanes::Lanes;
using portable_lanes::Wide;

namespace {

/// Of any size within 2^±40, with a low part.
DoubleDouble random_number(std::mt19937_64& random) {
  std::uniform_real_distribution<double> mantissa(-1, 1), exponent(-40, 40);
  const double high = std::exp2(exponent(random)) * mantissa(random);
  return two_sum(high, high * 0x1p-54 * mantissa(random));
}

DoubleDouble lane(const Wide& a, int i) { return {a.v.hi.lane(i), a.v.lo.lane(i)}; }

bool is_same(DoubleDouble a, DoubleDouble b) { return a.hi == b.hi && a.lo == b.lo; }

}  // namespace

TEST_CASE("twice the precision is in every lane that of one number") {
  std::mt19937_64 random(3);
  for (int repetition = 0; repetition < 200; ++repetition) {
    Wide a, b;
    for (int i = 0; i < Wide::count; ++i)
      for (Wide* wide : {&a, &b}) {
        const DoubleDouble number = random_number(random);
        wide->v.hi.set_lane(i, number.hi);
        wide->v.lo.set_lane(i, number.lo);
      }
    for (int i = 0; i < Wide::count; ++i) {
      const DoubleDouble x = lane(a, i), y = lane(b, i);
      CHECK(is_same(lane(a + b, i), x + y));
      CHECK(is_same(lane(a - b, i), x - y));
      CHECK(is_same(lane(a * b, i), x * y));
      CHECK(is_same(lane(a / b, i), x / y));
      CHECK(is_same(lane(absolute(a), i), x.hi < 0 ? -x : x));
      CHECK(is_same(lane(larger(a, b), i), x.hi > y.hi ? x : y));
      CHECK(is_same(lane(fused_minus(a, b, constant(1, Wide{})), i), DoubleDouble{1, 0} - x * y));
    }
  }
}
