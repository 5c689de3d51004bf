#include "solvers/lanes/distance_conditions.hpp"

#include <cmath>
#include <limits>

#include "solvers/lanes/lane_functions.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {

DifferenceMatrix difference_matrix(const DistanceSystem& system) {
  DifferenceMatrix matrix{system.equations(), system.unknowns(), {}};
  for (int row = 0; row < system.equations(); ++row) {
    const auto [a, b] = system.edges()[row];
    for (int axis = 0; axis < system.dimension(); ++axis) {
      const int of_a = 3 * a + axis, of_b = 3 * b + axis;
      if (const int column = system.unknown(a, axis); column >= 0)
        matrix.entries.push_back({row, column, of_a, of_b});
      if (const int column = system.unknown(b, axis); column >= 0)
        matrix.entries.push_back({row, column, of_b, of_a});
    }
  }
  return matrix;
}

std::vector<double> normalised_conditions(const DifferenceMatrix& matrix,
                                          std::span<const PointCoordinates> figures, InstructionSet set) {
  std::vector<double> conditions(figures.size());
  lane_functions(set).conditions(matrix, figures, conditions.data());
  for (double& condition : conditions)
    if (std::isnan(condition)) condition = std::numeric_limits<double>::infinity();
  return conditions;
}

}  // namespace gcs
