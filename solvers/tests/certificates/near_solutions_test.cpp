#include "solvers/certificates/near_solutions.hpp"

#include <catch2/catch.hpp>
#include <stop_token>
#include <string>
#include <utility>

using namespace gcs;

namespace {

/// x² = square and y² = 1, from (0, 1), next to which two solutions should be.
NearSolutions near_zero(const std::string& square, const std::stop_token& stop = {}) {
  const auto squared = [](int unknown) {
    const LinearForm form{{{unknown}}, {}};
    return FormProduct{form, form};
  };
  ExactNumber given;
  given.decimal = square;
  const QuadraticSystem system{2, {{{squared(0)}, given}, {{squared(1)}, exactly(1)}}, {-1, -1}};
  return solutions_near(system, {{{0, 1}, 2}}, 2, stop);
}

void check_two(const std::string& square, Certificate::Realness realness, double apart) {
  const NearSolutions settled = near_zero(square);
  INFO(square);
  CHECK(settled.multiple.empty());
  REQUIRE(settled.simple.size() == 2);
  for (const Certificate& solution : settled.simple) CHECK(solution.realness == realness);
  const auto difference = settled.simple[0].enclosure.mid[0] - settled.simple[1].enclosure.mid[0];
  CHECK(std::abs(difference) == Approx(apart));
}

/// x³ = slope·x + value by y = x², beside z = 1, from a point next to (0, 0, 1), next to which three solutions should be.
NearSolutions near_inflection(double slope, double value, const std::stop_token& stop = {}) {
  const LinearForm x{{{0}}, {}}, minus_x{{{0, exactly(-1)}}, {}}, y{{{1}}, {}}, rise{{{1}}, exactly(-slope)},
      z{{{2}}, {}}, whole{{}, exactly(1)};
  const QuadraticSystem system{
      3,
      {{{{x, rise}}, exactly(value)}, {{{y, whole}, {minus_x, x}}, {}}, {{{z, whole}}, exactly(1)}},
      {0, 0, 0}};
  return solutions_near(system, {{{1e-9, -1e-12, 1}, 3}}, 3, stop);
}

}  // namespace

TEST_CASE("two solutions next to a singular point are proven to be two, and real or not") {
  check_two("1e-10", Certificate::Realness::real, 2e-5);
  check_two("1e-26", Certificate::Realness::real, 2e-13);
  check_two("-1e-26", Certificate::Realness::not_real, 2e-13);
}

TEST_CASE("a double solution is settled as one") {
  const NearSolutions settled = near_zero("0");
  CHECK(settled.simple.empty());
  REQUIRE(settled.multiple.size() == 1);
  CHECK(settled.multiple[0].multiplicity == 2);
  CHECK(settled.count() == 2);
  CHECK(std::abs(settled.multiple[0].x[0]) <= 1e-14);
}

TEST_CASE("a triple solution is settled as one, and three that are apart as three") {
  const NearSolutions settled = near_inflection(0, 0);
  CHECK(settled.simple.empty());
  REQUIRE(settled.multiple.size() == 1);
  CHECK(settled.multiple[0].multiplicity == 3);
  CHECK(settled.multiple[0].is_real);
  CHECK(std::abs(settled.multiple[0].x[0]) <= 1e-20);
  // 0 and ±1e-6, of which 0 is the middle; three of the size 1e-6 with the middle 0, which is none.
  for (const auto& [slope, value] : {std::pair(1e-12, 0.0), {0.0, 1e-18}}) {
    const NearSolutions apart = near_inflection(slope, value);
    CHECK(apart.simple.size() == 3);
    CHECK(apart.multiple.empty());
  }
}

TEST_CASE("a search that is stopped settles nothing") {
  std::stop_source source;
  source.request_stop();
  CHECK(near_inflection(0, 0, source.get_token()).count() == 0);
  for (const char* square : {"0", "1e-10"}) CHECK(near_zero(square, source.get_token()).count() == 0);
}

TEST_CASE("solutions far from a point are not counted as next to it") {
  CHECK(near_zero("1e-4").count() == 0);
}
