#pragma once
/// Mixed cells in exact integers, so that what an enumeration in floating point found is proved.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solvers/polyhedral/supports.hpp"

namespace gcs {

/// One integer per point of each support.
using Lifting = std::vector<std::vector<std::int64_t>>;
/// Which two points are taken of each support, the smaller index first.
using CellEdges = std::vector<std::array<int, 2>>;

/// The solution α = numerators/volume of ⟨a − b, α⟩ = ω(b) − ω(a) for the edges {a, b}, where volume is the
/// absolute value of the determinant.
struct ExactNormal {
  std::int64_t volume = 0;
  std::vector<std::int64_t> numerators;
};

/// Nothing where the determinant is 0 or where it or a numerator may not fit 60 bits. Solved modulo 2^61 − 1;
/// that the integers so found solve the equations is checked in integers, and that the determinant is no
/// other integer of the same residue by Hadamard's inequality. Precondition: liftings below 2^40.
std::optional<ExactNormal> exact_normal(const Supports& supports, const Lifting& lifting,
                                        const CellEdges& edges);

/// Of ω(c) + ⟨c, α⟩ less its value on the edge, for point c of support i: 1 where c is higher than the edge,
/// 0 as high, −1 lower. Preconditions as above, exponents below 2^20.
int height_sign(const Supports& supports, const Lifting& lifting, const CellEdges& edges,
                const ExactNormal& normal, int i, int c);

}  // namespace gcs
