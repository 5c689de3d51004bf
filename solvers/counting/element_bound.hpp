#pragma once
/// How many solutions a general scene has at most when its elements are placed one set after the other: for each set a
/// multihomogeneous Bézout bound with its elements as groups of unknowns.

#include <optional>
#include <vector>

#include "solvers/numeric/natural.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Elements that are placed while others are held.
struct PlacedSet {
  std::vector<int> elements;  ///< those held and those placed
  std::vector<int> held;      ///< empty for a body
  bool is_body =
      false;        ///< on as many equations as it has freedoms; the ends of these are among the elements
  Natural at_most;  ///< ways, for each place of what is held
};

/// The product over all sets.
Natural ways_to_place(const std::vector<PlacedSet>& sets);

/// The sets in which a scene can be placed, from what is given, the body that the frame is put in, or those d points with all
/// their distances given that leave fewest ways. Nothing where there are none of these, or given positions leave motions; where a
/// constraint is not between two elements; where a set does not have as many equations as freedoms, or holds a body that is
/// not on legs; or where counting takes too long.
///
/// The unknowns of a point are p and s = p·p, of a plane n and h with n·n = 1, of a line u and m = p × u with u·u = 1 and
/// u·m = 0: each is a group. A constraint counts by its degree in each (ElementPolynomials), and of more equations than it
/// counts as, as many generic combinations are taken, which keep what is isolated. So the bound has the degrees of elements' own
/// equations and of constraints as factors, and the number of ways to give equations to one end each such that every element
/// gets as many as it has freedoms. (Bartzos, Emiris, Schicho, AAECC 31, 2020, for points.) A direction that is held already,
/// or a line through a point that is, takes two equations with it, likewise a line at a distance from a plane that is, on each
/// side; a constraint that only shifts such an element is linear. Lines, and planes whose sides nothing sees, come turned over
/// as well, as the same figure. A body on legs has the postures of a platform (Ronga, Vust 1992; Mourrain 1993; in the plane
/// Hunt 1983), about a point 8, of four quadrics of P³ by quaternions, about an axis 2; on a line 8, as its cosine, sine and
/// shift are on two quadrics and a plane for either direction of the line; on a plane 6, as in the plane. Where all legs end in
/// d points on one side, these with their distances tell the posture: they are placed as points are, and the lesser number
/// counts.
std::optional<std::vector<PlacedSet>> placed_sets(const ProblemStatement& problem);

}  // namespace gcs
