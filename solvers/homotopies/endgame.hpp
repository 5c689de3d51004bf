#pragma once
/// How paths x(t) of a homotopy from generic lengths (t = 0) to given ones (t = 1) end.
///
/// A path that runs into a regular solution is simply followed there. About the others a circle decides:
/// with σ = 1 − t, x is a series in σ^(1/w) with finitely many negative powers, and walking σ w times around
/// 0 brings x back. The discrete Fourier transform of the samples gives the series' terms (Cauchy's formula;
/// Morgan, Sommese, Wampler 1991): with no negative power the path is finite, at a singular point that w
/// paths share; with one it is at infinity like σ^(−k/w). A pole that lies beside σ = 0, of a finite solution
/// that is merely large, shows as powers lower than the leading one, which a pole at 0 has not; the circle
/// shrinks until it passes between the two, or until they are known to be less than 1e-12 apart.
/// Two circles must agree.

#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/lanes/monomial_system.hpp"

namespace gcs {

/// Of a regular end, relative to 1 + the largest |x_i|: Newton's last correction was far below its own square
/// root.
inline constexpr double regular_uncertainty = 1e-12;

/// Where the endgame begins: the last tenth of the way.
inline constexpr double first_radius = 0.1;

struct PathEnd {
  enum class Kind { regular, singular, at_infinity, failed, stopped };
  Kind kind = Kind::failed;
  ComplexVectorX x;        ///< of a finite end; else where the path was last, on a circle or before a failure
  int winding_number = 1;  ///< w
  int pole_order = 0;      ///< k: at infinity like σ^(−k/w)
  bool is_settled = false;  ///< Newton's method was tried on it
  std::string cause;        ///< why it failed, in words
  ComplexVectorX before{};  ///< x at σ = first_radius, of an end at infinity or one that failed; may be empty
  bool is_precise = false;  ///< every entry of x is right to its own rounding, however small beside others
};

/// Follows every start, a regular zero for the squared lengths `from`, to the squared lengths `to`.
/// `is_zero` tells of a multiple end whether rounding explains that it is no zero; where it does not, the
/// path goes on to smaller circles, which may tell apart several ends between which it lies.
std::vector<PathEnd> follow_to_end(LegTracking& tracking, const std::vector<ComplexVectorX>& starts,
                                   const ComplexVectorX& from, const ComplexVectorX& to,
                                   const std::function<bool(const ComplexVectorX&)>& is_zero,
                                   const std::function<bool()>& stopped,
                                   const std::function<void(double)>& progress, WorkCounters& work);

/// Where the paths from these starts are at σ = radius ≤ 1; empty where one is lost.
std::vector<ComplexVectorX> follow_to_radius(LegTracking& tracking, std::vector<ComplexVectorX> starts,
                                             const ComplexVectorX& from, const ComplexVectorX& to,
                                             double radius, const std::function<bool()>& stopped,
                                             WorkCounters& work);

/// Newton's method on ends that the trackers, whose order of elimination is fixed, did not take for regular ones or, where
/// small pivots enlarge rounding, left beside them. On `threads` ≥ 1.
void settle(const MonomialSystem& system, const ComplexVectorX& coefficients, int threads,
            std::vector<PathEnd>& ends);
void settle(const SquareSystem& system, const ComplexVectorX& squares, int threads,
            std::vector<PathEnd>& ends);

}  // namespace gcs
