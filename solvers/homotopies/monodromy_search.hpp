#pragma once
/// All solutions of a generic member of a family of distance equations, from one of them.
///
/// The squared lengths A are the parameters. A random complex placement x is a solution for its own A. Two
/// nodes A_0, A_1 are joined by arcs A(s); every arc followed from a known solution of one node gives a
/// solution of the other. The placements with their lengths are one irreducible variety, the graph of
/// x ↦ A(x), so that enough arcs reach all solutions; the images under one arc are distinct, since paths of
/// regular solutions do not meet, and where two are not, a step has jumped. (Duff, Hill, Jensen, Lee, Leykin,
/// Sommars 2018, "Solving polynomial systems via homotopy continuation and monodromy".)
///
/// Distances are homogeneous: scaling a placement by γ scales A by γ². Where no position is given an arc ends
/// at γ²A_1, with its own γ on the unit circle, and the solution is scaled back. Beside that every arc bends
/// by s(1 − s)B with a random B: straight ones of one pair of nodes lie in a plane, and group the branch
/// points in sectors of it, of which a few solutions may see no single one. The bend is B(s) = B, or
/// (1 − s)B + sC with two random ones: large ones go out in one direction and come back in another, so that solutions
/// that are far larger than the others meet branch points too. So do all arcs beyond the third, which bend ten times as far.
///
/// Where distances are all there is, A_0 is real, so that the conjugate of each solution is known with it: two arcs then reach
/// nearly all, along two legs for each. In the plane it is that of a real placement; in space one coordinate of each point
/// is imaginary. Real lengths there have many closed walks ±a ± b …, some nearly 0 by chance, next to whose zeros solutions are
/// far away; of real and imaginary ones hardly any is, and fewer square roots keep their signs along all arcs. A_1 stays complex,
/// since the arcs between two real ones keep the signs of many square roots. What is returned is turned by a random γ: the
/// way to other real lengths must not be real, nor nearly so.

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/homotopies/mirror_images.hpp"

namespace gcs {

/// A point and the parameters for which it is a zero.
struct FamilyMember {
  ComplexVectorX x;
  ComplexVectorX parameters;
};

/// Equations with parameters, some of them perhaps fixed.
struct HomotopyFamily {
  SignMasks signs;            ///< changes of signs that are divided out
  std::vector<bool> is_free;  ///< one per parameter: whether it may change
  /// Whether γx is a zero for γ² times the parameters.
  bool is_homogeneous = false;
  /// A member at random, in which the parameters that are not free have their values.
  std::function<FamilyMember(std::mt19937_64&)> random_member;
  /// One of real numbers, where the family is homogeneous and the conjugate of a member one; may be empty.
  std::function<FamilyMember(std::mt19937_64&)> real_member{};
};

/// Equations whose right-hand sides are the parameters.
HomotopyFamily square_family(const SquareSystem& system, SignMasks signs, std::vector<bool> is_free,
                             std::function<ComplexVectorX(std::mt19937_64&)> random_point);

/// Distance equations, with all squared lengths free.
HomotopyFamily all_lengths(const SquareSystem& system, SignMasks signs);

struct MonodromyOptions {
  /// Between the nodes, more for a large count; one more whenever the others find nothing new.
  int first_arcs = 3;
  int arcs = 12;               ///< at most
  double bend = 3;             ///< |B| over |A|, of the first three
  bool has_two_bends = false;  ///< those, too
};

/// How a search ended.
enum class SearchEnd {
  complete,      ///< as many solutions as the count that was given, or accepted by the test
  quiet,         ///< every arc from every solution leads to known ones
  inconsistent,  ///< two solutions have one image, or there are more than the count
  stopped
};

struct GenericSolutions {
  SearchEnd end = SearchEnd::stopped;
  ComplexVectorX squares;                 ///< A_0, or other parameters
  std::vector<ComplexVectorX> solutions;  ///< distinct up to reflections
  int arcs_used = 0;
  std::int64_t legs =
      0;  ///< handed out; once all solutions are known, the last ones are not followed to their ends
  std::int64_t lost_legs = 0;  ///< that ended nowhere; their solutions may be reached by other arcs
};

/// What says whether a search is done.
struct Completeness {
  std::optional<std::uint64_t> count;  ///< so many solutions are all
  /// Asked when the arcs in use lead to nothing new; may be empty.
  std::function<bool(const GenericSolutions&)> test;
};

/// `tracking` is of the family's system. Adds every leg's steps to `work`. `progress` hears of the number of
/// solutions so far.
GenericSolutions search_by_monodromy(const HomotopyFamily& family, LegTracking& tracking,
                                     const Completeness& completeness, const MonodromyOptions& options,
                                     std::mt19937_64& random, const std::function<bool()>& stopped,
                                     const std::function<void(int)>& progress, WorkCounters& work);

}  // namespace gcs
