#pragma once
/// Whether theta-scan finds for any length of the side that it leaves open what a very fine scan finds.

#include <vector>

#include "solvers/problem/problem_statement.hpp"
#include "solvers/pyramid/pyramid_branches.hpp"

namespace gcs {

/// What both find for one length.
struct OpenSideVerdict {
  double length = 0;          ///< of the open side, in the file's unit
  std::size_t solutions = 0;  ///< classes that the default finds
  std::size_t finer = 0;      ///< classes that the fine scan finds
  std::size_t together = 0;   ///< classes of both: equal to both where they agree
  bool is_complete = false;   ///< the default says that it has all
  double closest = 0;  ///< least distance of two solutions of the default, relative to the scene's size

  bool agrees() const { return is_complete && solutions == together && finer == together; }
};

/// Hoffmann and Yuan 2000, section 4.3, on a fine grid of angles for many lengths of one side: the curve
/// d34(θ) is sampled once. It knows nothing of enclosures, cells and branch ends.
class FineScan {
 public:
  /// `angles`: in a full turn. Precondition: the problem is a pyramid (find_pyramid).
  FineScan(const ProblemStatement& problem, int angles);

  /// Least and greatest sample of d34, in the file's unit.
  double shortest() const { return curve_.front().gap; }
  double longest() const { return curve_.back().gap; }

  /// The problem with that length, in the file's unit, of the open side.
  ProblemStatement with_length(double length) const;
  /// Real solutions for that length, distinct up to reflection, in the unit of the scene of with_length: from
  /// every sample within `band` (in the file's unit) of the length Newton's method starts.
  std::vector<Figure> solutions(double length, double band) const;

 private:
  ProblemStatement problem_;
  int open_side_ = -1;            ///< the constraint
  std::vector<GapSample> curve_;  ///< by gap, in the file's unit
};

/// The default of theta-scan against the fine scan.
OpenSideVerdict check_open_side(const FineScan& scan, double length, double band);

}  // namespace gcs
