#include "solvers/numeric/natural.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/tests/random_numbers.hpp"

using gcs::Natural;

TEST_CASE("natural numbers are written in decimal") {
  CHECK(Natural().decimal() == "0");
  CHECK(Natural(0) == Natural());
  CHECK(Natural(7).decimal() == "7");
  CHECK(Natural(~std::uint64_t{0}).decimal() == "18446744073709551615");
  CHECK(Natural::power_of_two(0) == Natural(1));
  CHECK(Natural::power_of_two(64).decimal() == "18446744073709551616");
  CHECK(Natural::power_of_two(100).decimal() == "1267650600228229401496703205376");
}

TEST_CASE("natural numbers obey the laws of arithmetic") {
  gcs::samples::RandomNumbers random(3);
  const auto number = [&] {
    Natural value(static_cast<std::uint64_t>(random.index(2'000'000'000)));
    for (int factors = random.index(6); factors > 0; --factors)
      value = value * Natural(static_cast<std::uint64_t>(random.index(2'000'000'000)) << random.index(32));
    return value;
  };
  const auto sum = [](Natural a, const Natural& b) { return a += b; };
  for (int i = 0; i < 200; ++i) {
    const Natural a = number(), b = number(), c = number();
    CHECK(sum(a, b) == sum(b, a));
    CHECK(a * b == b * a);
    CHECK(sum(a, b) * c == sum(a * c, b * c));
    CHECK((a * b) * c == a * (b * c));
    CHECK((sum(a, b) >= a && (b.is_zero() || sum(a, b) > a)));
    CHECK(a * Natural(4'000'000'007) / 4'000'000'007 == a);
    CHECK(a.approximate() == Approx(std::stod(a.decimal())).epsilon(1e-15));
  }
}

// (2^64 − 1)² + 2·(2^64 − 1) + 1 = 2^128: every limb carries.
TEST_CASE("carries run through") {
  const Natural ones(~std::uint64_t{0});
  Natural square = ones * ones;
  square += ones;
  square += ones;
  square += 1;
  CHECK(square == Natural::power_of_two(128));
  CHECK(square / 2 == Natural::power_of_two(127));
  CHECK(Natural(7) / 2 == Natural(3));
}
