#pragma once
/// Which points may go to infinity together.
///
/// Let some points escape like p/w, w → 0, all in one direction n, and the points next to them stay. Distances that stay
/// finite say n·n = 0, and that n·x is the same for all points next to the escaping ones: these lie in a plane whose
/// normal is isotropic and lies in it. In such a plane the bilinear product is that of one coordinate ℓ,
/// |x − y|² = (ℓ(x) − ℓ(y))². So given distances along a closed walk in it sum to 0 with some signs. Where they do, one of
/// them follows from the others, which makes room for the one condition too many that points are in such a plane.

#include <map>
#include <vector>

#include "solvers/model/scene.hpp"

namespace gcs {

/// Of each point: its neighbours, and the constraints that join them.
using Neighbours = std::vector<std::map<int, int>>;

/// Precondition: points and distances between them, nothing else.
Neighbours neighbours_of(const Scene& scene);

/// A closed walk of distances that sum to 0 with these signs: 3.9 + 4.3 = 3 + 2.7 + 2.5. No others of its corners are at a
/// given distance. Where points escape on both sides of a walk, its corners lie in two planes, and another walk may go
/// across it: the distance of two of its corners is a sum along it.
struct ClosedWalk {
  std::vector<int> corners;  ///< points, each once
  std::vector<int>
      edges;  ///< the constraint from each to the next, and from the last to the first, or −1: across
  std::vector<int> signs;  ///< 1 or −1 for each step, the first 1: Σ sign·length = 0 by the file's decimals
  int across = -1;         ///< the number of the walk that the last step is across; −1: it is an edge
};

/// All of them or, where there are very many to look at, the first ones; those that are across others come last.
/// Precondition: points and distances between them, nothing else.
std::vector<ClosedWalk> closed_walks(const Scene& scene);

/// Points that may escape.
struct Escape {
  std::vector<int> points;  ///< in order
  ClosedWalk walk;          ///< of all points next to these
  int number = -1;          ///< of the walk
};

/// Points that a walk separates from the points of the frame. Precondition as for closed_walks.
std::vector<Escape> escapes(const Scene& scene, const Reference& frame, const std::vector<ClosedWalk>& walks);

}  // namespace gcs
