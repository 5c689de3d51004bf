#pragma once
/// Evidence that a list of solutions is complete where no count says so: the trace test.
///
/// Let the squared lengths move along a line, A_0 + s·V. The placements x with A(x) = A_0 + s·V are a curve C
/// in (x, s), irreducible for a random line (Bertini), since all placements with their lengths are an
/// irreducible variety. For a function u on C, the points with u = ε are one fibre of a covering of the
/// ε-line, over which monodromy acts transitively. Sums of a function φ over all points of a fibre are
/// rational in ε, and polynomials where φ has poles only where u has them; if φ = O(u) there, they are affine
/// in ε. Over a part of a fibre they are not, but for accidents of φ. (Sommese, Verschelde, Wampler 2002; for
/// products of slices as here: Leykin, Rodriguez, Sottile 2018, "Trace test"; Hauenstein, Rodriguez 2019.)
///
/// s alone will not do for u: solutions escape to infinity at finite s, where sums have poles. Here
///   u = s·E,  E = Σ r_a x_a² − c
/// with random r over some coordinates and a random c: squares, since the sums of coordinates vanish with
/// mirror images. The equations may have other symmetries, which are not divided out: a component of the
/// graph that the points at 0 on an axis separate from the rest has images of its own. φ must tell them
/// apart, or it sums over the half of a fibre as over the whole: E and φ then have the squares of differences
/// between components too, and where no images are divided out of differences from constants. Where x escapes
/// at a finite s, E grows as all x_a² do; at s = ∞ placements grow like s^(1/2), u like s². So φ = Σ r'_a
/// x_a² + r'·s is O(u). The degree of the covering is N + M: N points with s = 0, which are the solutions
/// sought, and M with E = 0. All of them are searched for by monodromy in A_0 and ε; the sums at three values
/// of ε must lie on a line; then ε goes to almost 0, and N is counted.
///
/// Some solutions may be nearly separate from the rest, as those 1/δ away of a platform whose bodies are congruent but for
/// δ: loops miss the branch points that join them, some 1/δ² away, and the sums over the rest are off a line by δ² only.
/// Doubles do not see it; the sums are taken at zeros to some 50 digits.
///
/// It is evidence and no proof: φ might be unlucky, and the sums are numbers in floating point.

#include <cstdint>

#include "solvers/homotopies/monodromy_search.hpp"
#include "solvers/lanes/monomial_system.hpp"
#include "solvers/numeric/balls.hpp"

namespace gcs {

struct TraceTest {
  SearchEnd end = SearchEnd::stopped;  ///< of the search for the fibre; complete: its sums are affine
  std::int64_t points = 0;             ///< N + M
  std::int64_t solutions = 0;          ///< N
  double defect = 1;                   ///< of the three sums from a line, relative to their terms

  /// The equations' numbers are rounded to doubles, which makes a member of a special family one with a δ of 1e-16 or so
  /// and leaves 1e-32 times what weights make of it. From a δ of 1e-12 on a sum is off by more, and one that lacks one of
  /// hundreds of points by a part of its term.
  static constexpr double affine = 1e-29;
  bool is_affine() const { return defect <= affine; }
  bool passed() const { return end == SearchEnd::complete; }
};

/// The curve and the functions on it.
struct TraceProblem {
  HomotopyFamily family;        ///< of points with s·E = ε, with A_0 and ε free
  int s = 0;                    ///< its number among the unknowns
  int product = 0;              ///< the parameter that ε is, or minus that
  std::vector<Monomial> terms;  ///< that φ combines
  /// The zero next to x for these parameters, as precise_zero.
  std::function<std::optional<BallMatrix>(const ComplexVectorX& parameters, const ComplexVectorX& x)> zero;
};

/// `tracking` is of the family's system. Adds to `work`.
TraceTest test_trace(const TraceProblem& problem, LegTracking& tracking, const MonodromyOptions& options,
                     std::mt19937_64& random, const std::function<bool()>& stopped,
                     const std::function<void(int)>& progress, WorkCounters& work);

/// Precondition: all right-hand sides of `system` are squared lengths (see all_lengths).
/// Adds to `work`.
TraceTest test_trace(const SquareSystem& system, const std::vector<int>& mirror_axes,
                     const TrackingSetup& setup, const MonodromyOptions& options, std::mt19937_64& random,
                     const std::function<bool()>& stopped, const std::function<void(int)>& progress,
                     WorkCounters& work);

}  // namespace gcs
