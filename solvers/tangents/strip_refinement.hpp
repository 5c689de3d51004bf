#pragma once
/// Newton's method on a common tangent in isotropic coordinates and double-double.

#include <optional>
#include <vector>

#include "solvers/running/work.hpp"
#include "solvers/tangents/found_tangents.hpp"
#include "solvers/tangents/scaled_line.hpp"

namespace gcs {

struct RefinedTangent {
  ComplexTangent line;    ///< in the spheres' coordinates, with the point nearest to their origin
  ScaledLine in_strip{};  ///< the same, u·u = 1: its small coordinates are right as well
};

/// The common tangent near `line`, with u·u = 1: every coordinate is the nearest double to the exact one's, but for those of
/// `line` that are far below the others. Nothing where Newton's method does not converge as it does at a simple line.
/// Precondition: lengths are of order 1. Adds to `work`.
std::optional<RefinedTangent> refined_in_strip(const FourSpheres& spheres, const Strip& strip,
                                               const ScaledLine& line, WorkCounters& work);

/// Simple tangents that were refined in a strip, each once and with its conjugate.
class TangentsInStrip {
 public:
  explicit TangentsInStrip(const Strip& strip) : strip_(strip) {}

  void take(const RefinedTangent& tangent);

  FoundTangents found;

 private:
  const Strip& strip_;
  std::vector<ScaledLine> known_;
};

}  // namespace gcs
