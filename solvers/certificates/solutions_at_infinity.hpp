#pragma once
/// Solutions at infinity of scenes of points in space, proven, and with them that there are no more finite ones.
///
/// A solution at infinity is a regular zero of all equations around it (equations_at_infinity.hpp) that has w = 0. That it
/// has, and not a tiny w, is proven in two steps. Krawczyk's test finds a regular zero y of the equations with w = 0,
/// without one edge of a closed walk for each escape; these edges follow from the others by the file's decimals
/// (escapes.hpp). Then the test with all equations, whose one zero in its box is (y, 0), proves the Jacobian regular there.
///
/// By the implicit function theorem lengths near the given ones have one zero near it, which depends on them analytically.
/// Its w are not 0 at nearly all of them: the Jacobian is (F_y F_w; g_y 0), g being the edges left out. F_y is regular, and
/// so is its Schur complement S; if the squared lengths of g change by δ, the w change by S⁻¹δ, and no row of S⁻¹ is 0. So
/// one class of finite figures with generic lengths is next to each solution at infinity; and one is next to each regular
/// finite solution.
///
/// These classes differ. In one frame a figure says which points are far away, where the others are, and, but for signs of
/// axes, all unknowns: n is one of two isotropic directions orthogonal to the first edge of the walk, w and u follow from
/// the given linear form, q from these, and t from the equations. So figures next to two zeros are of one class only if
/// these are mirror images; and next to finite solutions no point is far away. When all together are as many as there can
/// be, there is no other figure, isolated or not: it would have figures with generic lengths next to it, of a class that
/// was not counted. No frame needs to have a bound of its own for that.

#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "solvers/certificates/dyadic_figure.hpp"
#include "solvers/certificates/escapes.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

struct ProvenAtInfinity {
  std::uint64_t classes = 0;  ///< different up to reflections
  int most_bits = 0;          ///< the highest precision that a proof took
  std::string why_not_all;    ///< of one that is not proven, in words; empty when all are
};

/// `near`: figures of the scene at other lengths next to solutions at infinity, in the scene's frame. All that is proven
/// belongs to one frame, of those with three points at given distances the first one in which the most are proven. The
/// same for any number of threads, unless stopped: then fewer are proven.
ProvenAtInfinity prove_at_infinity(const Scene& scene, const std::vector<Figure>& near, int threads,
                                   const std::stop_token& stop = {});

/// The same for checkers that somebody else has written.
struct DyadicAtInfinity {
  struct Solution {
    std::size_t way = 0;
    /// In the scene's unit: coordinates of the points that stay, as far as the frame leaves them open; then for each escape n,
    /// q, u (but of the first) and t of its points, and t of the walk's corners from the third on (equations_at_infinity.hpp).
    DyadicBox box;
  };
  Reference frame;
  std::vector<std::vector<Escape>> ways;  ///< to go to infinity
  std::vector<Solution> solutions;        ///< different up to reflections
};

/// Those that prove_at_infinity proves, but for such as take more than 1024 bits.
DyadicAtInfinity dyadic_at_infinity(const Scene& scene, const std::vector<Figure>& near, int threads);

}  // namespace gcs
