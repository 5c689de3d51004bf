#include "solvers/numeric/prime_field.hpp"

#include <catch2/catch.hpp>

namespace {

using gcs::Residue;
using gcs::ResidueMatrix;
using gcs::ResidueVector;

constexpr std::uint64_t p = (std::uint64_t{1} << 61) - 1;

ResidueMatrix matrix_of(const std::vector<std::vector<std::uint64_t>>& rows) {
  ResidueMatrix matrix;
  for (const auto& row : rows) {
    auto& target = matrix.emplace_back();
    for (const std::uint64_t entry : row) target.emplace_back(entry);
  }
  return matrix;
}

}  // namespace

TEST_CASE("arithmetic wraps at the prime") {
  CHECK(Residue(p).is_zero());
  CHECK((Residue(p - 1) + Residue(2)).value() == 1);
  CHECK((Residue(1) - Residue(2)).value() == p - 1);
  CHECK((-Residue(0)).is_zero());
  CHECK((Residue(p - 1) * Residue(p - 1)).value() == 1);
  CHECK((Residue(std::uint64_t{1} << 40) * Residue(std::uint64_t{1} << 40)).value() == std::uint64_t{1}
                                                                                           << 19);
}

TEST_CASE("every element but zero has an inverse") {
  std::mt19937_64 engine(3);
  for (int i = 0; i < 100; ++i) {
    const Residue a = Residue::random(engine);
    CHECK((a * a.inverse()).value() == 1);
  }
}

TEST_CASE("ranks of matrices of integers") {
  CHECK(gcs::rank({}) == 0);
  CHECK(gcs::rank(matrix_of({{0, 0}, {0, 0}})) == 0);
  CHECK(gcs::rank(matrix_of({{0, 2}, {3, 0}})) == 2);
  CHECK(gcs::rank(matrix_of({{1, 2, 3}, {4, 5, 6}, {7, 8, 9}})) == 2);
  CHECK(gcs::rank(matrix_of({{1, 2, 3}, {4, 5, 6}, {7, 8, 10}})) == 3);
  CHECK(gcs::rank(matrix_of({{1}, {1}, {1}})) == 1);
}

TEST_CASE("the null space is what the matrix maps to zero") {
  const ResidueMatrix matrix = matrix_of({{1, 2, 3, 4}, {2, 4, 7, 1}});
  const ResidueMatrix basis = gcs::null_space(matrix, 4);
  REQUIRE(basis.size() == 2);
  CHECK(gcs::rank(basis) == 2);
  for (const ResidueVector& vector : basis) {
    for (const ResidueVector& row : matrix) CHECK(gcs::dot(row, vector).is_zero());
  }
  CHECK(gcs::null_space({}, 3).size() == 3);
  CHECK(gcs::null_space(matrix_of({{1, 0}, {0, 1}}), 2).empty());
}

// Cramer's rule: 2x + 3y = 8 and 5x − y = 3 have the determinant −17 and the solution (1, 2).
TEST_CASE("a square system is solved up to its determinant") {
  const auto solution = gcs::solve(matrix_of({{2, 3, 8}, {5, p - 1, 3}}));
  REQUIRE(solution);
  CHECK(solution->determinant == -Residue(17));
  CHECK(solution->numerators == ResidueVector{-Residue(17), -Residue(34)});
  CHECK_FALSE(gcs::solve(matrix_of({{1, 2, 3}, {2, 4, 5}})));
}

TEST_CASE("rows become columns") {
  const ResidueMatrix transposed = gcs::transposed(matrix_of({{1, 2, 3}, {4, 5, 6}}), 3);
  CHECK(transposed == matrix_of({{1, 4}, {2, 5}, {3, 6}}));
}
