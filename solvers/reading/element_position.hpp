#pragma once
/// What the positions of elements of any kind say of each other.

#include <vector>

#include "solvers/elements/body_motion.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// What no motion changes of two elements.
struct Measure {
  bool is_distance = true;  ///< or a cosine
  double value = 0;         ///< from a plane's side with a sign
};

/// Of the same kinds of elements the same measures, but that parallel ones may have one more.
std::vector<Measure> measures(const ElementPosition& a, const ElementPosition& b);

}  // namespace gcs
