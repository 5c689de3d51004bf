#include "solvers/octahedron/exact_determinants.hpp"

#include <algorithm>

namespace gcs {
namespace {

using Rows = std::vector<std::vector<RationalPolynomial>>;

/// By its first row.
RationalPolynomial determinant(const Rows& rows) {
  if (rows.empty()) return Rational(1);
  RationalPolynomial sum = Rational(0);
  for (std::size_t column = 0; column < rows.size(); ++column) {
    Rows minor(rows.begin() + 1, rows.end());
    for (auto& row : minor) row.erase(row.begin() + static_cast<std::ptrdiff_t>(column));
    const RationalPolynomial term = rows[0][column] * determinant(minor);
    sum = column % 2 == 0 ? sum + term : sum - term;
  }
  return sum;
}

}  // namespace

RationalPolynomial SymbolicEntries::operator()(int p, int q) const {
  if (p == q) return Rational(is_plane(p) ? 1 : 0);
  for (std::size_t i = 0; i < 2; ++i) {
    const auto [a, a2] = octahedron_.pair[i];
    if (std::minmax(p, q) == std::minmax(a, a2)) return diagonals_[i];
  }
  return exact_(p, q);
}

RationalPolynomial gram_determinant(const SymbolicEntries& entries, int apex, std::vector<int> others) {
  if (entries.is_plane(apex))
    std::swap(apex, *std::ranges::find_if(others, [&](int element) { return !entries.is_plane(element); }));
  Rows rows;
  for (const int p : others) {
    auto& row = rows.emplace_back();
    for (const int q : others) row.push_back(doubled_product(entries, apex, p, q));
  }
  return determinant(rows);
}

namespace {

/// Of the diagonals aa' and bb'.
bool has_proven_curve(const Scene& scene, const Octahedron& octahedron) {
  const SymbolicEntries entries(scene, octahedron);
  const auto [a, a2] = octahedron.pair[0];
  const auto [b, b2] = octahedron.pair[1];
  const auto [c, c2] = octahedron.pair[2];
  RationalPolynomial curve = common_divisor(gram_determinant(entries, c, {a, a2, b, b2}),
                                            gram_determinant(entries, c2, {a, a2, b, b2}));
  const RationalPolynomial flat = gram_determinant(entries, a, {a2, b, b2});
  for (RationalPolynomial part = common_divisor(curve, flat); !part.is_constant();
       part = common_divisor(curve, flat))
    curve = curve.divided_by(part);
  return !curve.is_constant();
}

}  // namespace

bool is_proven_to_flex(const Scene& scene, const Octahedron& octahedron) {
  Octahedron turned = octahedron;
  for (int third = 0; third < 3; ++third) {
    if (has_proven_curve(scene, turned)) return true;
    std::rotate(turned.pair.begin(), turned.pair.begin() + 1, turned.pair.end());
  }
  return false;
}

}  // namespace gcs
