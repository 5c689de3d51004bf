#pragma once
/// What keeps the ends of paths from being all solutions of a scene.

#include <map>
#include <string>

namespace gcs {

/// Of one cause.
struct LostPaths {
  int count = 0;
  double condition = 0;  ///< the largest where they were lost
};

struct Shortcomings {
  std::map<std::string, LostPaths> lost;
  int jumps = 0;         ///< regular ends at which several paths arrived
  int not_isolated = 0;  ///< ends at which the Jacobian loses more rank than so many paths explain
  int lonely = 0;        ///< others without their conjugates
  int in_between = 0;    ///< singular ends that are no multiple solutions
  int too_far = 0;       ///< ends whose coordinates doubles do not hold finely enough

  /// Empty when there are none.
  std::string in_words() const;
};

}  // namespace gcs
