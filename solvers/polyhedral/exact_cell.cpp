#include "solvers/polyhedral/exact_cell.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/numeric/prime_field.hpp"

namespace gcs {
namespace {

__extension__ typedef __int128 Wide;

/// Row i: a − b of edge i, then ω(b) − ω(a).
std::vector<std::vector<std::int64_t>> edge_equations(const Supports& supports, const Lifting& lifting,
                                                      const CellEdges& edges) {
  std::vector<std::vector<std::int64_t>> rows;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const auto [a, b] = edges[i];
    std::vector<std::int64_t>& row = rows.emplace_back();
    for (std::size_t v = 0; v < supports.size(); ++v) row.push_back(supports[i][a][v] - supports[i][b][v]);
    row.push_back(lifting[i][b] - lifting[i][a]);
  }
  return rows;
}

/// log2 of Hadamard's bound on the determinant of the first n columns.
double hadamard_exponent(const std::vector<std::vector<std::int64_t>>& rows) {
  double exponent = 0;
  for (const auto& row : rows) {
    double square = 0;
    for (std::size_t v = 0; v < rows.size(); ++v) square += static_cast<double>(row[v] * row[v]);
    exponent += std::log2(square) / 2;
  }
  return exponent;
}

Residue residue(std::int64_t value) {
  return value < 0 ? -Residue(static_cast<std::uint64_t>(-value))
                   : Residue(static_cast<std::uint64_t>(value));
}

/// The integer of least absolute value.
std::int64_t lifted(Residue value) {
  const std::uint64_t positive = value.value();
  if (positive <= Residue::modulus / 2) return static_cast<std::int64_t>(positive);
  return -static_cast<std::int64_t>(Residue::modulus - positive);
}

bool solves(const std::vector<std::vector<std::int64_t>>& rows, const ExactNormal& normal) {
  const std::size_t n = rows.size();
  return std::all_of(rows.begin(), rows.end(), [&](const std::vector<std::int64_t>& row) {
    Wide left = 0;
    for (std::size_t v = 0; v < n; ++v) left += Wide{row[v]} * normal.numerators[v];
    return left == Wide{row[n]} * normal.volume;
  });
}

}  // namespace

std::optional<ExactNormal> exact_normal(const Supports& supports, const Lifting& lifting,
                                        const CellEdges& edges) {
  const auto equations = edge_equations(supports, lifting, edges);
  constexpr double most = 59.9;  // half the modulus is 2^60; less what the logarithms round
  if (hadamard_exponent(equations) > most) return std::nullopt;
  ResidueMatrix rows;
  for (const auto& equation : equations) {
    ResidueVector& row = rows.emplace_back();
    for (const std::int64_t entry : equation) row.push_back(residue(entry));
  }
  const std::optional<ScaledSolution> solution = solve(rows);
  if (!solution) return std::nullopt;
  const std::int64_t signed_volume = lifted(solution->determinant);
  ExactNormal normal{std::abs(signed_volume), {}};
  for (const Residue numerator : solution->numerators)
    normal.numerators.push_back(signed_volume < 0 ? -lifted(numerator) : lifted(numerator));
  if (!solves(equations, normal)) return std::nullopt;
  return normal;
}

int height_sign(const Supports& supports, const Lifting& lifting, const CellEdges& edges,
                const ExactNormal& normal, int i, int c) {
  const int a = edges[i][0];
  Wide height = Wide{normal.volume} * (lifting[i][c] - lifting[i][a]);
  for (std::size_t v = 0; v < supports.size(); ++v)
    height += Wide{supports[i][c][v] - supports[i][a][v]} * normal.numerators[v];
  return height > 0 ? 1 : (height < 0 ? -1 : 0);
}

}  // namespace gcs
