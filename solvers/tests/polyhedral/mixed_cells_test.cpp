#include "solvers/polyhedral/mixed_cells.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "solvers/tests/polyhedral/sample_supports.hpp"

using namespace gcs;

namespace {

MixedCells complete_cells(const Supports& supports, std::uint64_t seed = 1) {
  MixedCells cells = mixed_cells(supports, {seed, 1, {}});
  REQUIRE(cells.status == MixedCellStatus::complete);
  return cells;
}

Natural mixed_volume(const Supports& supports, std::uint64_t seed = 1) {
  return complete_cells(supports, seed).total_volume();
}

Natural stable_mixed_volume(const Supports& supports, std::uint64_t seed = 1) {
  const MixedCells cells = stable_mixed_cells(supports, {seed, 1, {}});
  REQUIRE(cells.status == MixedCellStatus::complete);
  return cells.total_volume();
}

std::int64_t turn(const Exponents& a, const Exponents& b, const Exponents& c) {
  return std::int64_t{b[0] - a[0]} * (c[1] - a[1]) - std::int64_t{b[1] - a[1]} * (c[0] - a[0]);
}

/// Twice the area of the convex hull, by A. M. Andrew's monotone chain.
std::int64_t twice_area(Support points) {
  std::sort(points.begin(), points.end());
  Support hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Exponents& point : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  std::int64_t area = 0;
  for (std::size_t i = 1; i + 1 < hull.size(); ++i) area += turn(hull[0], hull[i], hull[i + 1]);
  return area;
}

/// area(P + Q) − area(P) − area(Q).
std::int64_t mixed_area(const Support& p, const Support& q) {
  Support sum;
  for (const Exponents& a : p)
    for (const Exponents& b : q) sum.push_back({a[0] + b[0], a[1] + b[1]});
  return (twice_area(sum) - twice_area(p) - twice_area(q)) / 2;
}

bool is_lower_everywhere(const MixedCells& cells, const CellEdges& edges, const ExactNormal& normal) {
  for (int i = 0; i < static_cast<int>(cells.supports.size()); ++i)
    for (int c = 0; c < static_cast<int>(cells.supports[i].size()); ++c)
      if (c != edges[i][0] && c != edges[i][1] &&
          height_sign(cells.supports, cells.lifting, edges, normal, i, c) <= 0)
        return false;
  return true;
}

/// All pairs of points of every support, one choice after the other.
void append_cells(const MixedCells& cells, CellEdges& edges, std::vector<CellEdges>& found) {
  if (edges.size() == cells.supports.size()) {
    const auto normal = exact_normal(cells.supports, cells.lifting, edges);
    if (normal && is_lower_everywhere(cells, edges, *normal)) found.push_back(edges);
    return;
  }
  const int points = static_cast<int>(cells.supports[edges.size()].size());
  for (int a = 0; a < points; ++a) {
    for (int b = a + 1; b < points; ++b) {
      edges.push_back({a, b});
      append_cells(cells, edges, found);
      edges.pop_back();
    }
  }
}

/// x_v of each point becomes Σ matrix[v][w] x_w, and each support is moved.
Supports transformed(const Supports& supports, const std::vector<Exponents>& matrix,
                     samples::RandomNumbers& random) {
  Supports result = supports;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const int shift = random.index(9) - 4;
    for (std::size_t c = 0; c < supports[i].size(); ++c)
      for (std::size_t v = 0; v < matrix.size(); ++v)
        result[i][c][v] =
            std::inner_product(matrix[v].begin(), matrix[v].end(), supports[i][c].begin(), shift);
  }
  return result;
}

}  // namespace

// Cyclic roots: R. Fröberg and G. Björck (5: 70, 6: 156, 7: 924, and 8: 2560 by Emiris and Canny 1995).
// V. W. Noonburg's neural network: 3^n − 2n. Katsura's magnetism: 12 with n = 4.
TEST_CASE("mixed volumes of the literature") {
  CHECK(mixed_volume(samples::cyclic_roots(5)) == Natural(70));
  CHECK(mixed_volume(samples::cyclic_roots(6)) == Natural(156));
  CHECK(mixed_volume(samples::cyclic_roots(7)) == Natural(924));
  CHECK(mixed_volume(samples::cyclic_roots(8)) == Natural(2560));
  CHECK(mixed_volume(samples::noon(3)) == Natural(21));
  CHECK(mixed_volume(samples::noon(5)) == Natural(233));
  CHECK(mixed_volume(samples::katsura(4)) == Natural(12));
}

// Katsura's system has 2^n solutions; those with a zero coordinate are missed in the torus.
TEST_CASE("stable mixed volumes") {
  for (int n = 2; n <= 5; ++n)
    for (std::uint64_t seed = 1; seed <= 3; ++seed)
      CHECK(stable_mixed_volume(samples::katsura(n), seed) == Natural::power_of_two(n));
  // x² + x: the solutions −1 and 0. x + xy, y + xy: (0, 0) and (−1, −1).
  CHECK(stable_mixed_volume({{{1}, {2}}}) == Natural(2));
  CHECK(stable_mixed_volume({{{1, 0}, {1, 1}}, {{0, 1}, {1, 1}}}) == Natural(2));
  // x³ + x²: 0 counts twice.
  CHECK(stable_mixed_volume({{{2}, {3}}}) == Natural(3));
  // Where every support has the origin nothing is added.
  CHECK(stable_mixed_volume(samples::noon(3)) == Natural(21));
}

TEST_CASE("dense supports have Bézout's number") {
  CHECK(mixed_volume(samples::dense({7})) == Natural(7));
  CHECK(mixed_volume(samples::dense({3, 4})) == Natural(12));
  CHECK(mixed_volume(samples::dense({2, 3, 4})) == Natural(24));
  CHECK(mixed_volume(samples::dense({2, 1, 2, 3})) == Natural(12));
  CHECK(mixed_volume(samples::dense({2, 2, 2, 2, 2})) == Natural(32));
}

TEST_CASE("in two unknowns the mixed volume is the mixed area") {
  samples::RandomNumbers random(5);
  int zeros = 0;
  for (int i = 0; i < 200; ++i) {
    Supports supports = samples::random_supports(2, 1 + random.index(8), -4, 6, random);
    const std::int64_t expected = mixed_area(supports[0], supports[1]);
    CHECK(mixed_volume(supports, static_cast<std::uint64_t>(i)) ==
          Natural(static_cast<std::uint64_t>(expected)));
    zeros += expected == 0;
  }
  CHECK(zeros < 100);
}

TEST_CASE("the cells are those found by trying all pairs of points") {
  samples::RandomNumbers random(6);
  std::size_t found = 0;
  for (int i = 0; i < 40; ++i) {
    const int n = 2 + random.index(3);
    const Supports supports = samples::random_supports(n, 8 - n, -2, 3, random);
    const MixedCells cells = complete_cells(supports, static_cast<std::uint64_t>(i));
    CellEdges none;
    std::vector<CellEdges> expected;
    append_cells(cells, none, expected);
    REQUIRE(cells.cells.size() == expected.size());
    for (std::size_t k = 0; k < expected.size(); ++k) CHECK(cells.cells[k].edges == expected[k]);
    found += expected.size();
  }
  CHECK(found > 100);
}

TEST_CASE("mixed volumes do not change under symmetries of the lattice") {
  samples::RandomNumbers random(7);
  for (int i = 0; i < 20; ++i) {
    Supports supports = samples::random_supports(3, 5, 0, 3, random);
    const Natural volume = mixed_volume(supports);
    const std::vector<Exponents> shear{{1, 2, 0}, {0, 1, 0}, {-1, 0, 1}},
        swap{{0, 1, 0}, {1, 0, 0}, {0, 0, -1}};
    CHECK(mixed_volume(transformed(supports, shear, random)) == volume);
    CHECK(mixed_volume(transformed(supports, swap, random)) == volume);
    std::swap(supports[0], supports[2]);
    std::reverse(supports[1].begin(), supports[1].end());
    CHECK(mixed_volume(supports) == volume);
  }
}

TEST_CASE("every lifting gives the same mixed volume, and a seed the same cells on any number of threads") {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const MixedCells one = complete_cells(samples::cyclic_roots(6), seed);
    CHECK(one.total_volume() == Natural(156));
    const MixedCells four = mixed_cells(samples::cyclic_roots(6), {seed, 4, {}});
    CHECK(four.work.pivots == one.work.pivots);
    CHECK(four.work.linear_programs == one.work.linear_programs);
    REQUIRE(four.cells.size() == one.cells.size());
    for (std::size_t k = 0; k < one.cells.size(); ++k) {
      CHECK(four.cells[k].edges == one.cells[k].edges);
      CHECK(four.cells[k].normal == one.cells[k].normal);
    }
  }
  CHECK(complete_cells(samples::cyclic_roots(6), 1).lifting !=
        complete_cells(samples::cyclic_roots(6), 2).lifting);
}

TEST_CASE("a normal makes its edges equally high and all other points higher") {
  for (const MixedCells& cells :
       {complete_cells(samples::cyclic_roots(6)), stable_mixed_cells(samples::katsura(4), {1, 1, {}})}) {
    for (const MixedCell& cell : cells.cells) {
      for (std::size_t i = 0; i < cells.supports.size(); ++i) {
        std::vector<long double> heights;
        for (std::size_t c = 0; c < cells.supports[i].size(); ++c)
          heights.push_back(std::inner_product(cell.normal.begin(), cell.normal.end(),
                                               cells.supports[i][c].begin(),
                                               static_cast<long double>(cells.lifting[i][c])));
        const auto [a, b] = cell.edges[i];
        const long double edge = heights[a];
        // The lifting is an integer below 2^37, its rounding in a normal below 2^−10.
        CHECK(std::abs(heights[b] - edge) < 1e-3L);
        CHECK(std::count_if(heights.begin(), heights.end(),
                            [&](long double h) { return h < edge + 1e-3L; }) == 2);
      }
    }
  }
}

TEST_CASE("supports without a mixed cell") {
  CHECK(mixed_volume({{{1, 0}}, {{0, 0}, {1, 1}}}).is_zero());
  CHECK(mixed_volume({{{0, 0}, {1, 1}}, {{1, 0}, {3, 2}}}).is_zero());
}

TEST_CASE("what cannot be finished says so") {
  std::stop_source stop;
  stop.request_stop();
  const MixedCells stopped = mixed_cells(samples::cyclic_roots(5), {1, 1, stop.get_token()});
  CHECK(stopped.status == MixedCellStatus::stopped);
  CHECK(stopped.cells.empty());
  constexpr int large = 1 << 16;
  const MixedCells overflowing = mixed_cells({{{0, 0, 0, 0}, {large, 0, 0, 0}},
                                              {{0, 0, 0, 0}, {0, large, 0, 0}},
                                              {{0, 0, 0, 0}, {0, 0, large, 0}},
                                              {{0, 0, 0, 0}, {0, 0, 0, large}}},
                                             {1, 1, {}});
  CHECK(overflowing.status == MixedCellStatus::too_large);
}
