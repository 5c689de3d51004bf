#pragma once
/// In how many ways a closed chain of six bodies with given shapes closes, modulo a prime.

#include <optional>
#include <random>
#include <vector>

namespace gcs::samples {

/// For random hinges modulo 2^61 − 1, of which i and i + 1 meet in a point as `meets` says; complex motions,
/// those at infinity included, with multiplicity. Linear algebra alone: three rotations from body 0 to body 3
/// one way are a trilinear form f(u) with values in the dual quaternions, the other way g(v), and f(u) = g(v)
/// for some v if and only if g⁻¹f(u) is a tensor of rank 1, so that nine forms of degree (2, 2, 2) in u
/// vanish. S/I, the forms modulo the ideal of these, has dimension 16 in the degrees (3, 3, 3) and (4, 4, 4),
/// and multiplying by a form of degree (1, 1, 1) maps one onto the other, hence onto from there on: there
/// are finitely many solutions, no more than 16. Returns the dimension in these degrees, or nothing where the
/// two differ, the map is not onto or the eight coefficients of f or g are linearly dependent.
std::optional<int> count_closings(const std::vector<bool>& meets, std::mt19937_64& random);

}  // namespace gcs::samples
