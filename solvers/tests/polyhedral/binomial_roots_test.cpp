#include "solvers/polyhedral/binomial_roots.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <set>

using namespace gcs;

namespace {

/// How far M·θ − β is from integers.
double defect(const IntegerMatrix& exponents, const std::vector<double>& angles,
              const std::vector<double>& turns) {
  double worst = 0;
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    double sum = -turns[i];
    for (std::size_t v = 0; v < angles.size(); ++v) sum += static_cast<double>(exponents[i][v]) * angles[v];
    worst = std::max(worst, std::abs(sum - std::round(sum)));
  }
  return worst;
}

/// Angles on a grid far coarser than rounding and far finer than any two solutions here.
std::vector<long> rounded(const std::vector<double>& angles) {
  constexpr double grid = 1 << 26;
  std::vector<long> result;
  for (const double angle : angles) result.push_back(std::lround(angle * grid) % std::lround(grid));
  return result;
}

void check_all_roots(const IntegerMatrix& exponents, std::int64_t volume) {
  const std::optional<BinomialRoots> roots = BinomialRoots::of(exponents);
  REQUIRE(roots);
  REQUIRE(roots->volume() == volume);
  std::vector<double> turns;
  for (std::size_t i = 0; i < exponents.size(); ++i) turns.push_back(0.1234567 * static_cast<double>(i + 1));
  std::set<std::vector<long>> distinct;
  for (std::int64_t i = 0; i < volume; ++i) {
    const std::vector<double> angles = roots->angles(turns, i);
    CHECK(defect(exponents, angles, turns) < 1e-12);
    distinct.insert(rounded(angles));
  }
  CHECK(distinct.size() == static_cast<std::size_t>(volume));
}

/// Random elementary row operations on a diagonal: the determinant stays.
IntegerMatrix disguised(const std::vector<std::int64_t>& diagonal, std::mt19937_64& random) {
  const std::size_t n = diagonal.size();
  IntegerMatrix matrix(n, std::vector<std::int64_t>(n, 0));
  for (std::size_t i = 0; i < n; ++i) matrix[i][i] = diagonal[i];
  for (int step = 0; step < 6; ++step) {
    const std::size_t a = random() % n, b = random() % n;
    if (a == b) continue;
    for (std::size_t v = 0; v < n; ++v) matrix[a][v] += matrix[b][v];
    for (std::size_t i = 0; i < n; ++i) matrix[i][b] -= matrix[i][a];
  }
  return matrix;
}

}  // namespace

TEST_CASE("a binomial system has as many solutions as its determinant") {
  check_all_roots({{3}}, 3);
  check_all_roots({{2, 0}, {0, 2}}, 4);  // not cyclic
  check_all_roots({{1, 1}, {1, -1}}, 2);
  check_all_roots({{2, 1}, {-1, 3}}, 7);
  check_all_roots({{0, 1, 1}, {1, 0, 1}, {1, 1, 0}}, 2);
}

TEST_CASE("all solutions of disguised diagonal binomial systems are found") {
  std::mt19937_64 random(11);
  for (const std::vector<std::int64_t>& diagonal : {std::vector<std::int64_t>{2, 2, 2, 2, 2},
                                                    {1, 1, 6, 4},
                                                    {3, 9, 2},
                                                    {1, 1, 1, 1, 1, 1, 1, 8},
                                                    {12, 18, 5}}) {
    std::int64_t volume = 1;
    for (const std::int64_t entry : diagonal) volume *= entry;
    for (int i = 0; i < 5; ++i) check_all_roots(disguised(diagonal, random), volume);
  }
}

TEST_CASE("a singular binomial system is refused") {
  CHECK_FALSE(BinomialRoots::of({{1, 2}, {2, 4}}));
  CHECK_FALSE(BinomialRoots::of({{0}}));
}
