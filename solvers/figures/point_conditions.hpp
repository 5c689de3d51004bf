#pragma once
/// Condition numbers of many figures of one scene of points, side by side.

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "solvers/lanes/distance_conditions.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

/// With more, the decomposition of a dense matrix takes tenths of a second and more.
inline constexpr int most_dense_unknowns = 300;

class PointConditions {
 public:
  /// Nothing for a scene of more than points and distances, or of more unknowns than most_dense_unknowns.
  static std::optional<PointConditions> of(const Scene& scene);

  /// See jacobian_condition; the same for each figure whatever the others are.
  std::vector<double> conditions(std::span<const Figure* const> figures) const;

 private:
  explicit PointConditions(DifferenceMatrix jacobian) : jacobian_(std::move(jacobian)) {}

  DifferenceMatrix jacobian_;
};

}  // namespace gcs
