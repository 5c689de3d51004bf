#pragma once
/// All zeros in (C*)^n of a system of given supports with random coefficients, by polyhedral homotopies: B.
/// Huber, B. Sturmfels, Math. Comp. 64 (1995).
///
/// With the lifting ω and a mixed cell's normal α, x_v = y_v t^(α_v) turns Σ c_a t^(ω(a)) x^a into a system
/// in y whose monomials have the factor t^(h_a): h_a = 0 at the cell's two points of each support, and
/// h_a > 0 at the others. At t = 0 two monomials are left of each equation, a binomial system with as many
/// solutions as the cell has volume; from each a path leads to t = 1. All coefficients have modulus 1, and so
/// have the coordinates of the starts. With t = e^(τ) the factors are e^(h τ), and the way is one in τ from
/// where the lowest of them is small: the heights of a cell differ by orders of magnitude, and in t the paths
/// would be hard to follow near 0. (S. Kim, M. Kojima: Numerical stability of path tracing in polyhedral
/// homotopy continuation methods, Computing 73, 2004.)

#include <functional>
#include <random>

#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/numeric/sign_masks.hpp"
#include "solvers/polyhedral/mixed_cells.hpp"

namespace gcs {

/// Precondition: no monomial has a degree above 2 or a negative exponent.
MonomialSystem monomial_system(const Supports& supports);
/// The supports of which that is the system but for the order of factors.
Supports supports_of(const MonomialSystem& system);

/// The generators of a group of sign changes that change all monomials of an equation or none, whatever the coefficients.
SignMasks symmetric_signs(const Supports& supports, const SignMasks& signs);

struct GenericZeros {
  ComplexVectorX coefficients;        ///< one per monomial of the MonomialSystem, of modulus 1
  std::vector<ComplexVectorX> zeros;  ///< where the paths ended: one of each set of mirror images
  std::int64_t paths = 0;             ///< that were followed
  std::int64_t mirror_images = 1;     ///< of each zero, with itself: paths·mirror_images is the mixed volume
  std::int64_t lost = 0;              ///< paths that ended nowhere
  std::int64_t repeated = 0;          ///< paths that ended where another one had: a step has jumped
  std::int64_t unsolved_cells = 0;    ///< whose binomial system could not be solved in 64-bit integers
  bool stopped = false;

  bool is_complete() const { return !stopped && lost == 0 && repeated == 0 && unsolved_cells == 0; }
};

/// Of zeros that differ by changes of symmetric_signs only one is followed. Preconditions: `cells` is complete, and of
/// supports as for monomial_system. Adds to `work`.
GenericZeros follow_polyhedral_homotopies(const MixedCells& cells, const SignMasks& signs,
                                          const TrackingSetup& setup, std::mt19937_64& random,
                                          const std::function<bool()>& stopped,
                                          const std::function<void(double)>& progress, WorkCounters& work);

}  // namespace gcs
