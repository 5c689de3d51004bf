#include "solvers/figures/point_conditions.hpp"

#include "solvers/model/distance_system.hpp"

namespace gcs {

std::optional<PointConditions> PointConditions::of(const Scene& scene) {
  if (scene.problem().is_general() || scene.has_lines()) return std::nullopt;
  const DistanceSystem system(scene);
  if (system.unknowns() > most_dense_unknowns) return std::nullopt;
  return PointConditions(difference_matrix(system));
}

std::vector<double> PointConditions::conditions(std::span<const Figure* const> figures) const {
  std::vector<PointCoordinates> coordinates;
  for (const Figure* figure : figures)
    coordinates.push_back({figure->points.data(), figure->is_real() ? nullptr : figure->imaginary.data()});
  return normalised_conditions(jacobian_, coordinates);
}

}  // namespace gcs
