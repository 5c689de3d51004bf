#pragma once
/// How many solutions of a quadratic system lie together where its Jacobian is singular or nearly so.
///
/// About a point x₀ let x = x₀ + V₁a + V₂b with V₂ spanning the r directions that the Jacobian nearly takes
/// to zero, and combine the equations so that f = (f₁, f₂) with f₁ ≈ a and a linear part of f₂ near to zero.
/// What is left of f₂ is nearly q(b), r quadratic forms.
///
/// Theorem. Let |a_i| ≤ α_i, |b_j| ≤ β be a polydisc on which |f₁ − a|_i < α_i for all i, and where |b_j| = β
/// for some j let |f₂ − q(b)|_k < |q_k(b)| for some k. Then it holds exactly 2^r solutions, counted
/// with multiplicities. Proof: (a, q(b)) + t·(f − (a, q(b))) has no zero on its boundary for 0 ≤ t ≤ 1, so
/// the number of zeros inside is the same at t = 0 and at t = 1 (Rouché's theorem in several variables;
/// Lloyd, Degree Theory, 1978). The forms q have no common zero but b = 0, which thus is one of multiplicity
/// 2^r by Bézout's theorem. As f is quadratic, all bounds are sums of moduli of its coefficients.
///
/// So a double solution, or two that are close together, are a cluster of two (r = 1); where the forms have a
/// common zero, as at a solution of multiplicity three, nothing is proven.

#include <complex>
#include <optional>
#include <vector>

#include "solvers/model/ball_krawczyk.hpp"

namespace gcs {

/// So many solutions, with multiplicities, have |x_i − mid_i| ≤ radius_i for all i.
struct BallCluster {
  int solutions = 0;
  std::vector<double> radius;
};

/// The smallest cluster about x that the theorem proves, for r = 1 and 2.
std::optional<BallCluster> prove_cluster(const BallKrawczyk& system,
                                         const std::vector<std::complex<double>>& x);

}  // namespace gcs
