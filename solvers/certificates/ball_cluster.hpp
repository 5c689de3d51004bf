#pragma once
/// How many solutions of a quadratic system lie together where its Jacobian is singular or nearly so.
///
/// About a point x₀ let x = x₀ + V₁(a + A(b)) + V₂b with V₂ spanning the r directions that the Jacobian nearly takes
/// to zero and polynomials A, and combine the equations so that f = (f₁, f₂) with f₁ ≈ a: A follows the zeros of f₁ as a series.
/// What is left of f₂ there begins nearly with c_k b_k^d, one power of one coordinate in each.
///
/// As these changes are invertible, a and b are coordinates, and multiplicities of zeros stay.
///
/// Theorem. Let |a_i| ≤ α_i, |b_k| ≤ β be a polydisc on which |f₁ − a|_i < α_i for all i, and where |b_k| = β let
/// |f₂,k − c_k b_k^d| < |c_k| β^d, for each k. Then it holds exactly d^r solutions, counted
/// with multiplicities. Proof: (a, c_k b_k^d) + t·(f − (a, c_k b_k^d)) has no zero on its boundary for 0 ≤ t ≤ 1, so
/// the number of zeros inside is the same at t = 0 and at t = 1 (Rouché's theorem in several variables;
/// Lloyd, Degree Theory, 1978). As f is quadratic, all bounds are sums of moduli of its coefficients.
///
/// So a multiple solution at which the Jacobian loses one from its rank, or several simple ones close together, are a cluster
/// of d ≤ 8 (r = 1; A has degree 7); one at which it loses r ≤ 6 a cluster of 2^r, where coordinates are found so that f₂
/// begins with their squares: always for two quadratic forms without a common zero, whose combinations have two squares among
/// them, and where folds meet that have nothing to do with each other. Of others nothing is proven.

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

/// The cluster about x of the smallest β and r that the theorem proves.
std::optional<BallCluster> prove_cluster(const BallKrawczyk& system,
                                         const std::vector<std::complex<double>>& x);

/// How many solutions a polydisc that holds all points within reach_i of x_i is proven to hold: if as many are known there,
/// with their multiplicities, it holds no other one. 0 where nothing is proven. x may be balls about numbers that take more
/// digits.
int solutions_about(const BallKrawczyk& system, const BallMatrix& x, const std::vector<double>& reach);

/// The point next to x, 2 ≤ solutions ≤ 8, about which so many are proven to lie in a polydisc with β = 2^(−200/solutions), where
/// the Jacobian loses one from its rank. Newton's method along the curve finds it, which does not settle there otherwise. Precondition:
/// balls of 256 bits at least.
std::optional<BallMatrix> meeting_point(const BallKrawczyk& system,
                                        const std::vector<std::complex<double>>& x, int solutions);

}  // namespace gcs
