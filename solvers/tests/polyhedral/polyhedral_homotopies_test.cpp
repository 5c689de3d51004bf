#include "solvers/polyhedral/polyhedral_homotopies.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/mirror_images.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/tests/polyhedral/sample_supports.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

const std::function<bool()> never = [] { return false; };
const std::function<void(double)> silent = [](double) {};

MixedCells cells_of(const Supports& supports) {
  MixedCells cells = mixed_cells(supports, {1, 1, {}});
  REQUIRE(cells.status == MixedCellStatus::complete);
  return cells;
}

GenericZeros zeros_of(const MixedCells& cells, const std::vector<int>& axes,
                      const TrackingSetup& setup = {{}, widest_instruction_set(), 1}) {
  std::mt19937_64 random(5);
  WorkCounters work;
  return follow_polyhedral_homotopies(cells, axes, setup, random, never, silent, work);
}

std::vector<int> no_axes(const MixedCells& cells) { return std::vector<int>(cells.supports.size(), -1); }

/// Largest value of an equation relative to the largest of its terms, from the exponents themselves.
double relative_residual(const Supports& supports, const ComplexVectorX& coefficients,
                         const ComplexVectorX& x) {
  double worst = 0;
  std::size_t j = 0;
  for (const Support& support : supports) {
    std::complex<double> sum = 0;
    double size = 0;
    for (const Exponents& exponents : support) {
      std::complex<double> term = coefficients[j++];
      for (std::size_t v = 0; v < x.size(); ++v)
        for (int i = 0; i < exponents[v]; ++i) term *= x[v];
      sum += term;
      size = std::max(size, std::abs(term));
    }
    worst = std::max(worst, std::abs(sum) / size);
  }
  return worst;
}

double smallest_distance(const std::vector<ComplexVectorX>& points) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      smallest = std::min(smallest, distance(points[i], points[k]) / largest(points[i]));
  return smallest;
}

void check_zeros(const Supports& supports, std::int64_t mixed_volume) {
  const MixedCells cells = cells_of(supports);
  const GenericZeros found = zeros_of(cells, no_axes(cells));
  CHECK(found.is_complete());
  CHECK(found.paths == mixed_volume);
  REQUIRE(found.zeros.size() == static_cast<std::size_t>(mixed_volume));
  for (const ComplexVectorX& zero : found.zeros)
    CHECK(relative_residual(supports, found.coefficients, zero) < 1e-12);
  CHECK(smallest_distance(found.zeros) > 1e-6);
}

std::vector<int> axes_of(const ProblemStatement& problem) {
  const Scene scene(problem);
  return mirror_axes(scene, DistanceSystem(scene));
}

SparseEquations coordinates_of(const ProblemStatement& problem, std::mt19937_64& random) {
  const DistanceSystem system((Scene(problem)));
  return coordinate_equations(square_system(system), random_complex_vector(system.unknowns(), random));
}

}  // namespace

// Bernshtein 1975: generic coefficients have as many zeros in the torus as the mixed volume says; Bézout's
// number for dense equations, 12 for katsura-4.
TEST_CASE("random coefficients have as many zeros as the mixed volume") {
  check_zeros(samples::dense({2, 2}), 4);
  check_zeros(samples::dense({2, 1, 2, 2}), 8);
  check_zeros(samples::katsura(4), 12);
  samples::RandomNumbers random(3);
  for (int i = 0; i < 5; ++i) {
    Supports supports = samples::dense({2, 2, 2, 2});
    for (Support& support : supports)  // of 15 monomials keep 1 and some others
      while (support.size() > 6)
        support.erase(support.begin() + 1 + random.index(static_cast<int>(support.size()) - 1));
    const MixedCells cells = cells_of(supports);
    check_zeros(supports, static_cast<std::int64_t>(cells.total_volume().approximate()));
  }
}

TEST_CASE("one of each set of mirror images is followed") {
  std::mt19937_64 random(2);
  const Supports supports = coordinates_of(samples::k33(), random).supports;
  const MixedCells cells = cells_of(supports);
  const GenericZeros some = zeros_of(cells, axes_of(samples::k33()));
  CHECK(some.is_complete());
  CHECK(some.mirror_images == 4);
  CHECK(some.paths == 128);
  const GenericZeros all = zeros_of(cells, no_axes(cells));
  CHECK(all.is_complete());
  CHECK(all.paths == 512);
  SolutionSet classes(axes_of(samples::k33()), random);
  for (const ComplexVectorX& zero : some.zeros) classes.insert(zero, regular_uncertainty);
  REQUIRE(classes.size() == 128);
  for (const ComplexVectorX& zero : all.zeros) CHECK(classes.find(zero, regular_uncertainty) >= 0);
}

TEST_CASE("the bits of zeros depend on no instruction set and no thread") {
  std::mt19937_64 random(2);
  const MixedCells cells = cells_of(coordinates_of(samples::k33(), random).supports);
  const std::vector<int> axes = axes_of(samples::k33());
  const GenericZeros expected = zeros_of(cells, axes, {{}, InstructionSet::portable, 1});
  for (const InstructionSet set : {InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512})
    if (is_available(set)) CHECK(zeros_of(cells, axes, {{}, set, 2}).zeros == expected.zeros);
}

TEST_CASE("sparse equations and squares of differences have the same paths") {
  std::mt19937_64 random(8);
  const DistanceSystem system((Scene(samples::octahedron())));
  const SquareSystem squares = square_system(system);
  const ComplexVectorX start = random_complex_vector(system.unknowns(), random);
  const ComplexVectorX other = random_complex_vector(system.unknowns(), random);
  const auto straight = [](const ComplexVectorX& from, const ComplexVectorX& to) {
    const ComplexVectorX zero(from.size());
    Route route{{from, to, zero, zero}, to};
    for (std::size_t j = 0; j < from.size(); ++j) route.coefficients[1][j] -= from[j];
    return route;
  };
  const auto coefficients = [&squares](const ComplexVectorX& x) {
    ComplexVectorX all;
    for (const ComplexVectorX& some : coordinate_equations(squares, x).coefficients)
      all.insert(all.end(), some.begin(), some.end());
    return all;
  };
  const MonomialSystem monomials = monomial_system(coordinate_equations(squares, start).supports);
  const Elimination elimination = order_elimination(squares, random);
  const Route by_squares = straight(squares_at(squares, start), squares_at(squares, other));
  const Route by_monomials = straight(coefficients(start), coefficients(other));
  WorkCounters work;
  const auto end_of = [&](LegTracking& tracking, const Route& route) {
    const Leg leg{start.data(), &route};
    return tracking.follow(std::span(&leg, 1), never, work).front();
  };
  const TrackingSetup setup{{}, widest_instruction_set(), 1};
  LegTracking first(squares, elimination, setup), second(monomials, elimination, setup);
  const LegResult one = end_of(first, by_squares), two = end_of(second, by_monomials);
  REQUIRE(one.state.end == LegEnd::arrived);
  REQUIRE(two.state.end == LegEnd::arrived);
  CHECK(distance(one.x, two.x) <= 1e-10 * (1 + largest(one.x)));
  CHECK(distance(one.x, start) > 0.1);
}

TEST_CASE("a start is found where only the last of a cell's roots is one") {
  // Pairs of conics a x² + b y² + c = 0: all signs of the twelve unknowns are divided out, which leaves one path of 4096.
  constexpr int unknowns = 12;
  Supports supports;
  std::vector<int> signs;
  for (int v = 0; v < unknowns; ++v) {
    Exponents one(unknowns, 0), x = one, y = one;
    x[static_cast<std::size_t>(v - v % 2)] = 2;
    y[static_cast<std::size_t>(v - v % 2 + 1)] = 2;
    supports.push_back({x, y, one});
    signs.push_back(v);
  }
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    const MixedCells cells = mixed_cells(supports, {seed, 1, {}});
    REQUIRE(cells.total_volume() == Natural(4096));
    const GenericZeros found = zeros_of(cells, signs);
    CHECK(found.is_complete());
    CHECK(found.mirror_images == 4096);
    REQUIRE(found.zeros.size() == 1);
    CHECK(relative_residual(supports, found.coefficients, found.zeros.front()) < 1e-12);
  }
}
