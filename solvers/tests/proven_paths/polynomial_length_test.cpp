/// Bounds on a length of any degree along a polynomial t(s), against samples in 113 bits.

#include "solvers/proven_paths/polynomial_length.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/tests/quad.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using samples::magnitude;
using samples::Quad;
using samples::RandomNumbers;

namespace {

constexpr int order = 12;

/// The derivatives of a(t) by t, with parameters anywhere within their errors.
struct ExactLength {
  ExactLength(const EnclosedLength& length, RandomNumbers& random) {
    const auto within = [&](double value, double error) {
      return Quad(value) + Quad(random.uniform(-1, 1)) * Quad(error);
    };
    const LengthPath& path = length.path;
    const Quad start = within(path.at_sketch, length.sketch_error),
               end = within(path.at_target, length.target_error);
    powers = {start, end - start, 0};
    add(within(path.bend, length.bend_error), 1);
    for (std::size_t i = 0; i < path.higher.size(); ++i)
      add(within(path.higher[i], length.higher_errors[i]), i + 2);
  }

  /// c·(t^n − t^(n+1))
  void add(Quad c, std::size_t n) {
    powers.resize(std::max(powers.size(), n + 2), 0);
    powers[n] += c;
    powers[n + 1] -= c;
  }

  Quad at(Quad t, int derivative = 0) const {
    Quad value = 0;
    for (std::size_t i = powers.size(); i-- > static_cast<std::size_t>(derivative);) {
      Quad factor = 1;
      for (int k = 0; k < derivative; ++k) factor *= Quad(static_cast<double>(i) - k);
      value = value * t + factor * powers[i];
    }
    return value;
  }

  std::vector<Quad> powers;
};

Quad at(const Eigen::VectorXd& c, Quad s) {
  Quad value = 0;
  for (Eigen::Index n = c.size() - 1; n >= 0; --n) value = value * s + c[n];
  return value;
}

EnclosedLength random_length(int count, double error, RandomNumbers& random) {
  EnclosedLength length{{random.uniform(0.5, 2), random.uniform(0.5, 2), random.uniform(-2, 2)},
                        error * random.uniform(0, 1),
                        error * random.uniform(0, 1),
                        error * random.uniform(0, 1)};
  for (int i = 1; i < count; ++i) {
    length.path.higher.push_back(random.uniform(-2, 2));
    length.higher_errors.push_back(error * random.uniform(0, 1));
  }
  return length;
}

struct Along {
  Along(const EnclosedLength& of, double t0, RandomNumbers& random) : length(of), along(of, order) {
    t = Eigen::VectorXd::Zero(order + 1);
    t[0] = t0;
    for (int n = 1; n <= order; ++n) t[n] = random.uniform(-1, 1);
    along.expand(t);
  }

  EnclosedLength length;
  PolynomialLength along;
  Eigen::VectorXd t;
};

void check_bounds(const Along& test, double h, RandomNumbers& random) {
  const LengthBounds bounds = test.along.bound(h);
  const ExactLength exact(test.length, random);
  const auto off = [&](Quad s) { return exact.at(at(test.t, s)) - at(test.along.value(), s); };
  for (int i = -8; i <= 8; ++i) {
    const Quad s = Quad(h) * i / 8, t = at(test.t, s);
    CHECK(magnitude(off(s)) <= Quad(bounds.length_error));
    if (i < 8)
      CHECK(magnitude(off(s + Quad(h) / 8) - off(s)) <= Quad(bounds.length_speed_error) * Quad(h) / 8);
    CHECK(magnitude(exact.at(t, 1)) <= Quad(bounds.slope));
    CHECK(magnitude(exact.at(t, 1) - at(test.along.slope(), s)) <= Quad(bounds.slope_error));
    CHECK(magnitude(exact.at(t + Quad(random.uniform(-0.5, 0.5)), 2)) <= Quad(bounds.curvature));
    const double near = static_cast<double>(t) + random.uniform(-1, 1);
    CHECK(magnitude(exact.at(near) - Quad(test.length.path.value(near))) <= Quad(bounds.value_error));
    const Eigen::VectorXd factor =
        test.length.is_plain ? Eigen::VectorXd(Eigen::VectorXd::Unit(order + 1, 0)) : test.along.value();
    Quad rest = at(factor, s) * at(test.along.slope(), s), power = 1;
    for (int n = 0; n < 3; ++n, power *= s) {
      Quad coefficient = 0, size = 0;
      for (int k = 0; k <= n; ++k) {
        const Quad term = Quad(factor[k]) * Quad(test.along.slope()[n - k]);
        coefficient += term;
        size += magnitude(term);
      }
      CHECK(magnitude(Quad(test.along.pull()[n]) - coefficient) <= Quad(1e-15) * size);
      rest -= power * coefficient;
    }
    CHECK(magnitude(rest) <= Quad(bounds.pull_rest) + Quad(1e-30));
  }
}

}  // namespace

TEST_CASE("bounds on a length of any degree hold for samples") {
  RandomNumbers random(1);
  for (const int count : {1, 2, 3, 6, 16})
    for (const double error : {0.0, 1e-15, 1e-6})
      for (int trial = 0; trial < 10; ++trial) {
        EnclosedLength length = random_length(count, error, random);
        length.is_plain = trial % 2 == 1;
        const Along test(length, random.uniform(-1, 2), random);
        for (const double h : {1e-3, 0.05, 0.4}) {
          CAPTURE(count, error, h);
          check_bounds(test, h, random);
        }
      }
}

TEST_CASE("bounds on a length are sharp where tubes are short") {
  RandomNumbers random(2);
  for (const int count : {2, 5})
    for (int trial = 0; trial < 10; ++trial) {
      const Along test(random_length(count, 0, random), random.uniform(0, 1), random);
      const LengthBounds bounds = test.along.bound(1e-3);
      const ExactLength exact(test.length, random);
      CHECK(bounds.length_error <= 1e-12);
      CHECK(bounds.slope_error <= 1e-11);
      CHECK(bounds.slope <= static_cast<double>(magnitude(exact.at(test.t[0], 1))) + 0.2);
      CHECK(bounds.pull_rest <= 1e-5);
    }
}

TEST_CASE("the polynomial of a length is that of the composition") {
  // a(t) = 2 + t(1 − t)(3 + t) along t = s + s² is 2 + 3s + s² − 5s³ + …, multiplied out by hand.
  EnclosedLength length{{2, 2, 3, {1}}};
  length.higher_errors = {0};
  PolynomialLength along(length, order);
  Eigen::VectorXd t = Eigen::VectorXd::Zero(order + 1);
  t[1] = t[2] = 1;
  along.expand(t);
  // 3t − 2t² − t³
  CHECK(along.value()[0] == 2);
  CHECK(along.value()[1] == 3);
  CHECK(along.value()[2] == 1);
  CHECK(along.value()[3] == -5);
  CHECK(along.value()[6] == -1);
  // 3 − 4t − 3t²
  CHECK(along.slope()[0] == 3);
  CHECK(along.slope()[1] == -4);
  CHECK(along.slope()[2] == -7);
  CHECK(along.slope()[3] == -6);
  CHECK(along.slope()[4] == -3);
}
