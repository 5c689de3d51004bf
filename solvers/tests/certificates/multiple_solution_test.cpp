/// Multiple solutions in fractions, whose multiplicities are known in closed form.

#include "solvers/certificates/multiple_solution.hpp"

#include <catch2/catch.hpp>

#include "solvers/certificates/certificate.hpp"
#include "solvers/tests/sample_forms.hpp"

using namespace gcs;

namespace {

/// (x − 1/4)^power = 0, with the powers in between as unknowns.
QuadraticSystem power_of_difference(int power) {
  const LinearForm difference = unknown(0, 1, -0.25);
  std::vector<QuadraticEquation> equations;
  for (int i = 1; i < power - 1; ++i)
    equations.push_back(
        {{{difference, i == 1 ? difference : unknown(i - 1)}, {unknown(i, -1), number(1)}}, {}});
  equations.push_back({{{difference, power == 2 ? difference : unknown(power - 2)}}, {}});
  return square_system(equations);
}

std::vector<Rational> at_quarter(std::size_t unknowns) {
  std::vector<Rational> x(unknowns);
  x.front() = Rational(1) / 4;
  return x;
}

/// The circles about (0, 0) and (3, 4), of the radii 2 and another one.
QuadraticSystem touching_circles(const std::string& other_radius) {
  const auto squared = [](const std::string& text) {
    ExactNumber number = decimal(text);
    number.is_squared = true;
    return number;
  };
  return square_system({{{{unknown(0), unknown(0)}, {unknown(1), unknown(1)}}, squared("2")},
                        {{{unknown(0, 1, -3), unknown(0, 1, -3)}, {unknown(1, 1, -4), unknown(1, 1, -4)}},
                         squared(other_radius)}});
}

/// x_k² = 0
QuadraticSystem squares(int count) {
  std::vector<QuadraticEquation> equations;
  for (int k = 0; k < count; ++k) equations.push_back({{{unknown(k), unknown(k)}}, {}});
  return square_system(equations);
}

}  // namespace

TEST_CASE("fractions are the simplest ones within the radius, of numbers that may be real") {
  const auto x = simplest_fractions({0.33333333, -1.75000001, {1e-12, 1e-11}}, {1e-6, 1e-6, 1e-10});
  REQUIRE(x);
  CHECK((*x)[0] == Rational(1) / 3);
  CHECK((*x)[1] == Rational(-7) / 4);
  CHECK((*x)[2].is_zero());
  CHECK(!simplest_fractions({{1, 1e-9}}, {1e-10}));
}

TEST_CASE("a power's zero has its degree for multiplicity, and no point beside it is a zero") {
  for (int power = 2; power <= 8; ++power) {
    const QuadraticSystem system = power_of_difference(power);
    CHECK(least_multiplicity(system, at_quarter(system.equations.size()), 64) == power);
    CHECK(least_multiplicity(system, at_quarter(system.equations.size()), 2) == 2);
    CHECK(least_multiplicity(system, std::vector<Rational>(system.equations.size()), 64) == 0);
  }
}

TEST_CASE("of r independent squares the zero has the multiplicity 2^r") {
  for (int count = 1; count <= 6; ++count)
    CHECK(least_multiplicity(squares(count), std::vector<Rational>(static_cast<std::size_t>(count)), 64) ==
          1 << count);
}

TEST_CASE("a simple zero has the multiplicity 1, and coefficients that are no fractions tell nothing") {
  QuadraticSystem system = square_system({{{{unknown(0), number(1)}}, exactly(0.5)}});
  CHECK(least_multiplicity(system, {Rational(1) / 2}, 64) == 1);
  system.equations[0].given.divided_by_norm_of = {exactly(1), exactly(1)};
  CHECK(least_multiplicity(system, {Rational(1) / 2}, 64) == 0);
  system.equations[0].given = exactly(60);
  system.equations[0].given.is_cosine_of_degrees = true;
  CHECK(least_multiplicity(system, {Rational(1) / 2}, 64) == 0);
}

TEST_CASE("circles touch in one point, or meet in two that doubles do not tell apart") {
  const std::vector<std::complex<double>> near{1.2, 1.6};
  const Certificate touching = Certifier(touching_circles("3")).certify(near);
  CHECK(touching.cluster == 2);
  CHECK(touching.is_multiple);
  CHECK(touching.holds_one());
  CHECK(touching.realness == Certificate::Realness::real);
  const std::string zeros(40, '0');
  for (const std::string& more : {"3." + zeros + "1", "2." + std::string(40, '9')}) {
    const Certificate two = Certifier(touching_circles(more)).certify(near);
    CHECK(!two.is_multiple);
    CHECK((two.is_proven || two.cluster == 2));
  }
}
