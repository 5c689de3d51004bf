#pragma once
/// Ends of paths at which doubles do not hold the lengths: far away, or at infinity.
///
/// Rounding the squared lengths A by δ moves an end that runs away like σ^(−p) to a finite one of size δ^(−p) or back, so
/// doubles do not tell which of the two the file has. The path to its own lengths, f(x) = A + σ·way, is followed on in
/// balls' arithmetic: x is extrapolated in log σ, by the same weights for all its entries, so that differences of points
/// that are far away together come out as well as these, and settled by Newton's method. Lengths are measured beside the
/// edges: |h| = max over e of |h_a − h_b| / |x_a − x_b|, e = ab.
///
/// The end is finite where Smale's α is small: the Jacobian J does not depend on A, so that with
///   β = |J⁻¹(f(x) − A)|,  γ = |J⁻¹ D²f|/2,  β·γ < (13 − 3·√17)/4
/// x is an approximate zero for A + σ'·way for every σ' from σ down to 0, and these zeros are one path (Blum, Cucker, Shub,
/// Smale, Complexity and Real Computation (1998), chapter 8). It is at infinity where that is so nowhere down to σ = 1e-80,
/// and if doubles did not say so, where x grows like a power there.

#include <functional>
#include <stop_token>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/general_family.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

/// Of so many paths, by their numbers, x at this σ, or nothing.
using EndsBefore = std::function<std::vector<ComplexVectorX>(const std::vector<std::size_t>&, double)>;

/// Whether ends of its paths are continued: points at distances, with nothing given.
bool has_precise_ends(const Scene& scene);

/// Makes ends finite that are, of those that failed beside their end and of those at infinity that the file's lengths do not
/// explain; `from` and `to` are the squared lengths in doubles that the paths went between. Explained: `to` is exactly the
/// file's, or in space lengths of the file let points escape (escapes.hpp). Where it would take more than seconds, those that
/// are not explained are believed in the plane, where they need no such lengths, and in space have failed. Precondition:
/// has_precise_ends(scene), whose frame the ends are in. On `threads` ≥ 1.
void continue_ends(const Scene& scene, const ComplexVectorX& from, const ComplexVectorX& to, int threads,
                   std::vector<PathEnd>& ends, const std::stop_token& stop);

/// Follows paths in balls that ended, in doubles, at singular points or where the Jacobian is nearly so: solutions next to a
/// curve of them, such as a scene that all but moves has, are anywhere on it by lengths in doubles. Whether all of them have
/// an end now that is determined; where one has none, as in a scene that moves, others are not tried. Not where it
/// would take more than seconds. Precondition as above.
bool determine_ends(const Scene& scene, const ComplexVectorX& from, const ComplexVectorX& to,
                    const EndsBefore& before, int threads, std::vector<PathEnd>& ends,
                    const std::stop_token& stop);

/// The same for paths of a general scene that go from these coefficients to the given ones, which differ in values alone:
/// those that are open get the ends that are determined, and the others, if they were said to be at infinity, have failed.
/// Whether that was tried: not where they are more than a twentieth of the paths and would take more than seconds. On
/// `threads` ≥ 1.
bool determine_ends(const GeneralEquations& given, const ComplexVectorX& from,
                    const std::function<bool(const PathEnd&)>& is_open, const EndsBefore& before, int threads,
                    std::vector<PathEnd>& ends, const std::stop_token& stop);

}  // namespace gcs
