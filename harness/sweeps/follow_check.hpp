#pragma once
/// Where figures move to when their values change, by gcs::follow, against what Newton's method from the old figure gives at
/// the new values, which is what CAD systems do.

#include <cstdint>
#include <vector>

#include "solvers/reading/instance_parser.hpp"
#include "solvers/solving/follow.hpp"

namespace gcs {

/// Of random changes of a scene.
struct FollowTally {
  int changes = 0;
  int reached = 0, folds = 0, undecided = 0;  ///< by follow with proof; undecided: without one
  int differs = 0;                            ///< follow without proof says something else
  /// Newton's method where the solution is reached: it fails; lands at another solution, in which the orientation of some
  /// points is another one; or at another one in which none is.
  int fails = 0, flips = 0, elsewhere = 0;
  int silent = 0;                   ///< Newton's method finds a solution where the figure folds before
  double proof_s = 0, track_s = 0;  ///< processor time of follow, with and without proof
};

/// `count` changes, from real solutions on S in turn, of every length, offset and angle by up to `part` of it. The same seed
/// gives the same changes.
FollowTally tally_changes(const Instance& instance, const std::vector<Figure>& from, double part, int count,
                          std::uint64_t seed);

/// The real solutions on S, in the file's unit; none where there is no S.
std::vector<Figure> solutions_on_path(const Instance& instance);

}  // namespace gcs
