/// Affine forms against the functions that they enclose, in quadruple precision.

#include "solvers/numeric/affine_form.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "solvers/tests/quad.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::Quad;
using samples::RandomNumbers;

namespace {

using Form = AffineForm<2>;

/// What a form says of its quantity at a point of the cell, and how far it may be off.
struct Value {
  Quad linear;
  Quad rest;
};

Value at(const Form& form, const std::array<double, 2>& xi) {
  return {Quad(form.mid) + Quad(form.slope[0]) * xi[0] + Quad(form.slope[1]) * xi[1], Quad(form.rest)};
}

bool holds(const Form& form, const std::array<double, 2>& xi, Quad exact) {
  const Value value = at(form, xi);
  const Quad off = exact - value.linear;
  return off <= value.rest && -off <= value.rest;
}

/// Linear, without remainder.
Form random_form(RandomNumbers& random, double mid, double reach) {
  Form form(mid);
  for (double& s : form.slope) s = random.uniform(-reach, reach) / 2;
  return form;
}

/// Calls check(x, y, ξ, x at ξ, y at ξ) on random cells, wide and narrow, and random and extreme points of
/// them.
template <class Check>
void on_random_cells(const Check& check) {
  RandomNumbers random(7);
  for (int i = 0; i < 2000; ++i) {
    const double reach = std::exp2(-random.uniform(0, 40));
    const Form x = random_form(random, random.uniform(1, 3), reach);
    const Form y = random_form(random, random.uniform(-2, 2), reach);
    for (int j = 0; j < 8; ++j) {
      std::array<double, 2> xi{random.uniform(-1, 1), random.uniform(-1, 1)};
      if (j < 4) xi = {j % 2 == 0 ? -1.0 : 1.0, j / 2 == 0 ? -1.0 : 1.0};
      check(x, y, xi, at(x, xi).linear, at(y, xi).linear);
    }
  }
}

}  // namespace

TEST_CASE("sums, products and squares hold their values") {
  on_random_cells([](const Form& x, const Form& y, const std::array<double, 2>& xi, Quad a, Quad b) {
    REQUIRE(holds(x + y, xi, a + b));
    REQUIRE(holds(x - y, xi, a - b));
    REQUIRE(holds(x * y, xi, a * b));
    REQUIRE(holds(x * y - y * x, xi, 0));
    REQUIRE(holds(square(y), xi, b * b));
    REQUIRE(holds(0.3 * x, xi, Quad(0.3) * a));
  });
}

TEST_CASE("roots and reciprocals hold their values, across zero too") {
  on_random_cells([](const Form& x, const Form& y, const std::array<double, 2>& xi, Quad a, Quad b) {
    const Form root = sqrt(x);
    // r² = a for the exact root r: compare squares, monotone on both sides.
    const Value r = at(root, xi);
    REQUIRE((r.linear + r.rest) * (r.linear + r.rest) >= a);
    REQUIRE((r.linear - r.rest) * (r.linear - r.rest) <= a);
    REQUIRE(holds(reciprocal(x), xi, 1 / a));
    if (!(y.high() > 0) || b < 0) return;
    const Value s = at(sqrt(y), xi);
    REQUIRE((s.linear + s.rest) * (s.linear + s.rest) >= b);
    REQUIRE((s.linear - s.rest <= 0 || (s.linear - s.rest) * (s.linear - s.rest) <= b));
  });
}

TEST_CASE("cosines and sines hold their values") {
  on_random_cells([](const Form& x, const Form&, const std::array<double, 2>& xi, Quad a, Quad) {
    const auto [c, s] = cosine_and_sine(x);
    // By the addition theorem around the double nearest to a.
    const double near = static_cast<double>(a);
    const Quad step = a - Quad(near);
    REQUIRE(holds(c, xi, Quad(std::cos(near)) - step * Quad(std::sin(near))));
    REQUIRE(holds(s, xi, Quad(std::sin(near)) + step * Quad(std::cos(near))));
  });
}

TEST_CASE("remainders fall with the square of the cell") {
  for (const double reach : {1e-2, 1e-4, 1e-6}) {
    Form x(1.5);
    x.slope = {reach, -reach};
    const Form value = sqrt(square(x) + 1.0) * reciprocal(x);
    CHECK(value.rest <= 20 * reach * reach + 1e-14);
    CHECK(value.reach() > reach / 10);
  }
}

TEST_CASE("a number has a reciprocal where doubles hold the slope of it") {
  CHECK(has_reciprocal(Form(1e-150)));
  for (const double x : {0.0, -1.0, 1e-160, 1e-300, std::numeric_limits<double>::quiet_NaN()})
    CHECK_FALSE(has_reciprocal(Form(x)));
}
