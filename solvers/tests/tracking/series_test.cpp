#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "solvers/tests/random_numbers.hpp"
#include "solvers/tracking/arc_series.hpp"
#include "solvers/tracking/corrector.hpp"
#include "solvers/tracking/edge_series.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Polynomial = std::vector<long double>;

Polynomial product(const Polynomial& a, const Polynomial& b) {
  Polynomial c(a.size() + b.size() - 1, 0);
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) c[i + j] += a[i] * b[j];
  return c;
}

ArcSeries random_series(Eigen::Index coordinates, int order, RandomNumbers& random) {
  ArcSeries series(coordinates, order);
  for (int n = 0; n <= order; ++n)
    for (Eigen::Index i = 0; i < coordinates; ++i) series.coefficient(n)[i] = random.uniform(-1, 1);
  return series;
}

void add(long double factor, const Polynomial& b, Polynomial& a) {
  a.resize(std::max(a.size(), b.size()), 0);
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += factor * b[i];
}

/// a(t0 + δ(s))²/2 as a polynomial in s, multiplied out.
Polynomial half_square(const LengthPath& path, double t0, const Polynomial& offset) {
  Polynomial time = offset, left(offset.size(), 0), length;
  time[0] += t0;
  add(-1, time, left);
  left[0] += 1;
  add(path.at_sketch, left, length);
  add(path.at_target, time, length);
  Polynomial weight = product(time, left);
  add(path.bend, weight, length);
  for (const double c : path.higher) {
    weight = product(weight, time);
    add(c, weight, length);
  }
  Polynomial result = product(length, length);
  for (long double& value : result) value /= 2;
  return result;
}

}  // namespace

TEST_CASE("a series is evaluated as the sum of its terms") {
  RandomNumbers random(1);
  const ArcSeries series = random_series(5, 12, random);
  CHECK(series.order() == 12);
  for (const double s : {0.0, 0.3, -0.7, 1.0}) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(5);
    Eigen::VectorXd slope = Eigen::VectorXd::Zero(5);
    for (int n = 0; n <= 12; ++n) {
      sum += std::pow(s, n) * series.coefficient(n);
      if (n > 0) slope += n * std::pow(s, n - 1) * series.coefficient(n);
    }
    Eigen::VectorXd value;
    series.evaluate(s, value);
    CHECK((value - sum).norm() <= 1e-14);
    series.tangent(s, value);
    CHECK((value - slope.normalized()).norm() <= 1e-14);
  }
}

TEST_CASE("the arc length term makes every order of the squared speed vanish") {
  RandomNumbers random(2);
  constexpr int order = 14;
  ArcSeries series = random_series(4, order, random);
  series.coefficient(1).normalize();
  for (int n = 2; n <= order; ++n) {
    // Any c_n whose component along c_1 is the prescribed one will do.
    const Eigen::VectorXd c1 = series.coefficient(1);
    const Eigen::VectorXd across = series.coefficient(n) - c1 * c1.dot(series.coefficient(n));
    series.coefficient(n) = across + c1 * series.arc_length_term(n);
  }
  for (int power = 0; power < order; ++power) {
    double sum = 0;
    double size = 0;
    for (int i = 1; i <= power + 1; ++i) {
      const int j = power + 2 - i;
      const double term = i * j * series.coefficient(i).dot(series.coefficient(j));
      sum += term;
      size += std::abs(term);
    }
    CAPTURE(power);
    CHECK(std::abs(sum - (power == 0 ? 1 : 0)) <= 1e-14 * (1 + size));
  }
}

TEST_CASE("the step keeps the last two terms below the tolerance") {
  RandomNumbers random(3);
  ArcSeries series = random_series(3, 9, random);
  for (const double tolerance : {1e-3, 1e-9, 1e-12}) {
    const double step = series.step_for(tolerance);
    const double last = series.coefficient(9).norm() * std::pow(step, 9);
    const double last_but_one = series.coefficient(8).norm() * std::pow(step, 8);
    CHECK(std::max(last, last_but_one) == Approx(tolerance).epsilon(1e-10));
  }
  const double step = series.step_for(1e-9);
  series.coefficient(9).setZero();
  CHECK(series.step_for(1e-9) >= step);
  series.coefficient(8).setZero();
  CHECK(series.step_for(1e-9) == std::numeric_limits<double>::infinity());
}

TEST_CASE("the step and the radius are found of coefficients whose squares overflow") {
  ArcSeries series(3, 40);
  for (int n = 0; n <= 40; ++n) series.coefficient(n).setConstant(std::pow(1e5, n));
  CHECK(series.step_for(1e-7) == Approx(1e-5 * std::pow(1e-7 / std::sqrt(3.0), 1 / 39.0)));
  CHECK(series.radius() == Approx(1e-5));
}

TEST_CASE("the radius of convergence is seen however weak the singularity, whatever the parity") {
  for (const int order : {4, 11, 12})
    for (const int parity : {0, 1, 2}) {
      ArcSeries series(2, order);
      for (int n = 0; n <= order; ++n)
        series.coefficient(n).setConstant(parity == 2 || n % 2 == parity ? 1e-11 * std::pow(8, n) : 0);
      series.coefficient(0) << 3, 4;
      CAPTURE(order, parity);
      if (order > 4) CHECK(series.step_for(1e-7) > 0.125);
      CHECK((parity == 2 ? series.radius() == Approx(0.125) : series.radius() >= 0.125));
    }
}

TEST_CASE("rounding and vanishing coefficients show no radius of convergence") {
  ArcSeries series(2, 12);
  for (int n = 0; n <= 12; ++n) series.coefficient(n).setConstant(n < 2 ? 1 : 0);
  CHECK(series.radius() == std::numeric_limits<double>::infinity());
  for (int n = 2; n <= 12; ++n) series.coefficient(n).setConstant(1e-17 * std::pow(5, n));
  CHECK(series.radius() == std::numeric_limits<double>::infinity());
}

TEST_CASE("half convolutions are half the double sum over lower orders") {
  RandomNumbers random(4);
  for (const int dimension : {2, 3}) {
    constexpr int order = 11;
    constexpr Eigen::Index edges = 7;
    EdgeSeries series(edges, dimension, order);
    CHECK(series.edges() == edges);
    for (int n = 0; n <= order; ++n)
      for (Eigen::Index i = 0; i < edges * dimension; ++i) series.difference(n)[i] = random.uniform(-1, 1);
    Eigen::VectorXd fast(edges);
    for (int n = 1; n <= order; ++n) {
      fast.setOnes();
      series.subtract_half_convolution(n, fast);
      for (Eigen::Index e = 0; e < edges; ++e) {
        double slow = 1;
        for (int i = 1; i < n; ++i)
          for (int axis = 0; axis < dimension; ++axis)
            slow -= series.difference(i)[axis * edges + e] * series.difference(n - i)[axis * edges + e] / 2;
        CHECK(std::abs(fast[e] - slow) <= 1e-14);
      }
    }
  }
}

TEST_CASE("edges can be added to an edge series") {
  EdgeSeries series(2, 2, 3);
  series.resize(5);
  CHECK(series.edges() == 5);
  for (int n = 0; n <= 3; ++n) series.difference(n).setConstant(1);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(5);
  series.subtract_half_convolution(3, result);
  CHECK(result == Eigen::VectorXd::Constant(5, -2));
}

TEST_CASE("the series of the half squared lengths are those of the composition") {
  RandomNumbers random(5);
  constexpr int order = 12;
  std::vector<LengthPath> paths;
  for (int i = 0; i < 6; ++i)
    paths.push_back({random.uniform(0, 2), random.uniform(0, 2), i % 2 == 0 ? 0 : random.uniform(-3, 3)});
  paths[2].higher = {0.7};
  paths[3].higher = {-0.5, 0, 0.3, 0.2};
  LengthSeries series(paths, order);
  // The second round shows that nothing is left of the first.
  for (const double t0 : {0.0, -0.8, 1.7}) {
    series.start(t0);
    Polynomial offset(order + 1, 0);
    for (int n = 1; n <= order; ++n) offset[n] = random.uniform(-1, 1);
    std::vector<Polynomial> expected;
    for (const LengthPath& path : paths) expected.push_back(half_square(path, t0, offset));
    Eigen::VectorXd known(6);
    series.set(1, static_cast<double>(offset[1]));
    for (int n = 2; n <= order; ++n) {
      series.known(n, known);
      series.set(n, static_cast<double>(offset[n]));
      for (Eigen::Index i = 0; i < 6; ++i) {
        const double full = known[i] + series.slope(i) * static_cast<double>(offset[n]);
        CHECK(full == Approx(static_cast<double>(expected[i][n])).epsilon(1e-12).margin(1e-12));
      }
    }
    double shortest = std::numeric_limits<double>::infinity();
    for (const LengthPath& path : paths)
      shortest = std::min(shortest, path.value(0.3) / std::max(path.at_sketch, path.at_target));
    CHECK(series.shortest(0.3) == shortest);
    for (Eigen::Index i = 0; i < 6; ++i) {
      CHECK(series.value(i) == paths[i].value(t0));
      CHECK(series.slope(i) == paths[i].value(t0) * paths[i].slope(t0));
    }
  }
}

TEST_CASE("the corrector settles on noise, on quadratic promise, and refuses what does not contract") {
  using Verdict = CorrectorTest::Verdict;
  const double tolerance = 1e-9;
  SECTION("a correction at the level of rounding settles at once") {
    CHECK(CorrectorTest(tolerance).judge(1e-15, 1) == Verdict::settled);
    CHECK(CorrectorTest(tolerance).judge(0, 1) == Verdict::settled);
    CHECK(CorrectorTest(tolerance).judge(1e-12, 1000) == Verdict::settled);
  }
  SECTION("a correction beyond a hundred tolerances is refused") {
    CHECK(CorrectorTest(tolerance).judge(1.01e-7, 1) == Verdict::refuse);
    CHECK(CorrectorTest(tolerance).judge(std::numeric_limits<double>::quiet_NaN(), 1) == Verdict::refuse);
    CHECK(CorrectorTest(tolerance).judge(std::numeric_limits<double>::infinity(), 1) == Verdict::refuse);
  }
  SECTION("corrections that fall fast settle before they reach the noise") {
    CorrectorTest test(tolerance);
    CHECK(test.judge(1e-8, 1) == Verdict::again);
    CHECK(test.judge(1e-9 / 2, 1) == Verdict::again);
    CHECK(test.judge(1e-12, 1) == Verdict::settled);
  }
  SECTION("corrections that hardly fall are refused") {
    CorrectorTest test(1e-7);
    CHECK(test.judge(1e-6, 1) == Verdict::again);
    CHECK(test.judge(2e-7, 1) == Verdict::refuse);
  }
  SECTION(
      "small corrections that hardly fall may be rounding, which residuals in double-double do not have") {
    CorrectorTest test(tolerance);
    CHECK(test.judge(1e-10, 1) == Verdict::again);
    CHECK(test.judge(9e-11, 1) == Verdict::stalled);
    test.widen();
    CHECK(test.judge(9e-11, 1) == Verdict::again);
    CHECK(test.judge(8e-11, 1) == Verdict::refuse);
  }
  SECTION("near the noise, corrections that hardly fall are taken for rounding") {
    CorrectorTest test(tolerance);
    CHECK(test.judge(1e-12, 1) == Verdict::again);
    CHECK(test.judge(9e-13, 1) == Verdict::settled);
  }
}
