#pragma once
/// A polynomial system that somebody wrote down for a geometric problem, and the way back from its zeros.

#include <functional>
#include <optional>
#include <string>

#include "solvers/model/complex_points.hpp"
#include "solvers/problem/problem_statement.hpp"
#include "solvers/systems/polynomial_system.hpp"

namespace gcs {

struct WrittenSystem {
  PolynomialSystem equations;
  Reference reference;  ///< whose frame the placements are in
  /// The points of a zero, in the scene's unit. Not finite where there are none.
  std::function<ComplexPoints(const ComplexVectorX& zero)> place;
  /// Mirror images of a solution, itself included, that are zeros of their own.
  int mirror_images = 1;
  /// Whether a zero belongs to equations that were multiplied with what may vanish, and not to the problem; empty:
  /// never.
  std::function<bool(const ComplexVectorX& zero)> is_extraneous = {};
};

/// A scene's system, or why it has none.
struct SystemOrReason {
  std::optional<WrittenSystem> system;
  std::string why_none;
};

}  // namespace gcs
