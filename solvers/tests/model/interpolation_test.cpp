/// Lengths on the way from the sketch to the target, against rational arithmetic and against polynomials whose roots
/// are known.

#include "solvers/model/interpolation.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "solvers/model/bend_defect.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/numeric/rational.hpp"
#include "solvers/running/errors.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double infinity = std::numeric_limits<double>::infinity();

using Polynomial = std::vector<Rational>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] = c[i + j] + a[i] * b[j];
  return c;
}

Polynomial sum(Polynomial a, const Polynomial& b) {
  a.resize(std::max(a.size(), b.size()));
  for (std::size_t i = 0; i < b.size(); ++i) a[i] = a[i] + b[i];
  return a;
}

Rational exact(double value) { return Rational::from_double(value); }

/// a(t + τ) in powers of τ by the definition, multiplied out.
Polynomial expanded(const LengthPath& path, double t) {
  const Polynomial time{exact(t), Rational(1)}, left{Rational(1) - exact(t), Rational(-1)};
  Polynomial bend{exact(path.bend)}, power = time;
  for (const double c : path.higher) {
    bend = sum(bend, product({exact(c)}, power));
    power = product(power, time);
  }
  return sum(sum(product({exact(path.at_sketch)}, left), product({exact(path.at_target)}, time)),
             product(product(time, left), bend));
}

/// With up to `count` coefficients.
LengthPath random_path(int count, RandomNumbers& random) {
  LengthPath path{random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(-2, 2)};
  for (int i = 1; i < count; ++i) path.higher.push_back(random.uniform(-2, 2));
  return path;
}

double error(const Rational& exactly, double value) {
  return std::abs((exactly - exact(value)).approximate());
}

/// A triangle whose first side is bent.
ProblemStatement triangle(const std::vector<double>& coefficients) {
  ProblemStatement problem = samples::problem_of(2, 3, {{0, 1}, {0, 2}, {1, 2}}, {1, 0.9, 0.8});
  problem.sketch = Figure{Eigen::Matrix3Xd::Zero(3, 3), {}};
  problem.sketch->points.col(1) << 1, 0, 0;
  problem.sketch->points.col(2) << 0.5, 0.75, 0;
  problem.interpolation.bends = {{0, coefficients}};
  return problem;
}

}  // namespace

TEST_CASE("values, slopes and expansions of lengths are those of rational arithmetic, within their bounds") {
  RandomNumbers random(1);
  for (const int count : {1, 2, 3, 5, 16})
    for (int trial = 0; trial < 20; ++trial) {
      const LengthPath path = random_path(count, random);
      const double t = trial == 0 ? 0 : trial == 1 ? 1 : random.uniform(-2, 3);
      const Polynomial truth = expanded(path, t);
      const std::vector<double> terms = path.expansion(t), sizes = path.expansion_sizes(t);
      CAPTURE(count, t);
      REQUIRE(static_cast<int>(terms.size()) == path.degree() + 1);
      REQUIRE(terms.size() == truth.size());
      CHECK(terms[0] == path.value(t));
      CHECK(terms[1] == path.slope(t));
      for (std::size_t k = 0; k < terms.size(); ++k)
        CHECK(error(truth[k], terms[k]) <= (4 * path.degree() + 16) * epsilon * sizes[k]);
    }
}

TEST_CASE("sizes of an expansion bound what other parameters change, and are met") {
  RandomNumbers random(2);
  for (int trial = 0; trial < 20; ++trial) {
    const LengthPath change = random_path(4, random);
    const double t = random.uniform(-2, 3);
    const std::vector<double> sizes = change.expansion_sizes(t);
    const Polynomial moved = expanded(change, t);
    for (std::size_t k = 0; k < sizes.size(); ++k)
      CHECK(std::abs(moved[k].approximate()) <= sizes[k] * (1 + 1e-12));
  }
  // At t = −1 the terms of 1 − t, −t(1 − t), t²(1 − t) have one sign where the parameters' signs alternate.
  const LengthPath alternating{1, -2, -3, {4}};
  CHECK(alternating.expansion_sizes(-1)[0] == Approx(std::abs(expanded(alternating, -1)[0].approximate())));
}

TEST_CASE("lengths are exact at the sketch and at the target") {
  RandomNumbers random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const LengthPath path = random_path(1 + trial % 16, random);
    CHECK(path.value(0) == path.at_sketch);
    CHECK(path.value(1) == path.at_target);
  }
}

TEST_CASE("the positive support ends at the first roots on both sides") {
  // (2 − t)(1 + t)(1 + t²) = 2 + 2t − t(1 − t)(1 − t²); the others reach further or do not end.
  const LengthPath quartic{2, 4, -1, {0, 1}};
  const LengthPath linear{9, 6, 0}, constant{1, 1, 0};
  // (3 − t)(1 + t²) = 3 + t − t(1 − t)(2 − t)
  const LengthPath cubic{3, 4, -2, {1}};
  const TimeRange both = positive_support({quartic, linear, constant, cubic});
  CHECK(both.low == Approx(-1).epsilon(1e-12));
  CHECK(both.high == Approx(2).epsilon(1e-12));
  CHECK(both.is_bounded());
  const TimeRange one = positive_support({cubic, constant});
  CHECK(one.low == -infinity);
  CHECK(one.high == Approx(3).epsilon(1e-12));
  CHECK_FALSE(one.is_bounded());
  // 1 + 4t(1 − t) vanishes at (1 ± √2)/2.
  const TimeRange bent = positive_support({{1, 1, 4}});
  CHECK(bent.low == Approx((1 - std::sqrt(2)) / 2).epsilon(1e-12));
  CHECK(bent.high == Approx((1 + std::sqrt(2)) / 2).epsilon(1e-12));
  // One length shrinks and another grows.
  CHECK(positive_support({{1, 2, 0}, {3, 2, 0}}).low == Approx(-1));
  CHECK(positive_support({{1, 2, 0}, {3, 2, 0}}).high == Approx(3));
}

TEST_CASE("a length that only rounding changes does not end the positive support") {
  CHECK(positive_support({{1, 1 + epsilon, 0}}).low == -infinity);
  CHECK(positive_support({{1, 1 - epsilon, 0}}).high == infinity);
  CHECK(positive_support({{1, 1 - 1e-9, 0}}).high == Approx(1e9).epsilon(1e-6));
}

TEST_CASE("only where the positive support has no end is anything far away") {
  const LengthPath cubic{3, 4, -2, {1}};
  const TimeRange far = times_far_away({cubic});
  CHECK(far.high == infinity);
  CHECK(far.low <= -3000);  // a thousand times the root at 3
  CHECK(far.low >= -30000);
  CHECK(times_far_away({{1, 1, 4}}).low == -infinity);
  CHECK(times_far_away({{1, 1, 4}}).high == infinity);
  CHECK(times_far_away({{1, 1, 0}}).high == 1000);
}

TEST_CASE("bends of a scene are those of its problem in its unit, and scale with it") {
  ProblemStatement problem = samples::octahedron();
  problem.interpolation.bends = {{7, {1.5, 0.25, -3, 0, 0}}, {2, {}}, {3, {0, 0.5}}};
  const Scene scene = Scene::unchecked(problem);
  const double unit = std::ldexp(1.0, scene.unit_exponent());
  CHECK(scene.length_paths()[7].bend * unit == 1.5);
  REQUIRE(scene.length_paths()[7].higher.size() == 2);
  CHECK(scene.length_paths()[7].higher[0] * unit == 0.25);
  CHECK(scene.length_paths()[7].higher[1] * unit == -3);
  CHECK(scene.length_paths()[3].bend == 0);
  CHECK(scene.length_paths()[3].higher == std::vector<double>{0.5 / unit});
  for (const int linear : {0, 2, 11}) {
    CHECK(scene.length_paths()[linear].bend == 0);
    CHECK(scene.length_paths()[linear].higher.empty());
  }
  for (const int exponent : {-900, -1, 40, 900}) {
    ProblemStatement other = problem;
    for (DistanceConstraint& c : other.constraints) c.given.value = std::ldexp(c.given.value, exponent);
    other.sketch = other.sketch->scaled(exponent);
    for (BentLength& bent : *other.interpolation.bends)
      for (double& c : bent.coefficients) c = std::ldexp(c, exponent);
    const Scene scaled = Scene::unchecked(other);
    for (int i = 0; i < scene.constraint_count(); ++i) {
      CHECK(scaled.length_paths()[i].bend == scene.length_paths()[i].bend);
      CHECK(scaled.length_paths()[i].higher == scene.length_paths()[i].higher);
    }
  }
}

TEST_CASE("a length that is not positive on the way is refused") {
  // 1 + c·t(1 − t) is 1 + c/4 at t = 1/2.
  CHECK_FALSE(bend_defect(triangle({-3.999999}), {0, {-3.999999}}));
  for (const double c : {-4.0, -4.000001, -400.0}) {
    const auto defect = bend_defect(triangle({c}), {0, {c}});
    REQUIRE(defect);
    CHECK_THAT(defect->what, Catch::Contains("the length of 'a1' is not positive near t = 0.5"));
    CHECK_THROWS_AS(Scene(triangle({c})), InputError);
  }
  // 1 + c·t²(1 − t) is least at t = 2/3, 1 + 4c/27.
  CHECK_FALSE(bend_defect(triangle({0, -6.7499}), {0, {0, -6.7499}}));
  const auto cubic = bend_defect(triangle({0, -6.7501}), {0, {0, -6.7501}});
  REQUIRE(cubic);
  CHECK_THAT(cubic->what, Catch::Contains("near t = 0.66"));
  CHECK_NOTHROW(Scene(triangle({1, -2, 3})));
}

TEST_CASE("too many coefficients and such as are no numbers are refused") {
  CHECK_FALSE(bend_defect(triangle({}), {0, std::vector<double>(16, 0.1)}));
  CHECK_THAT(bend_defect(triangle({}), {0, std::vector<double>(17, 0.1)})->what, Catch::Contains("17"));
  CHECK_THAT(bend_defect(triangle({}), {0, {1, infinity}})->what, Catch::Contains("not finite"));
  CHECK_THAT(bend_defect(triangle({}), {0, {std::nan("")}})->what, Catch::Contains("not finite"));
}
