#pragma once
/// Condition numbers of the Jacobians of distances at many figures, side by side.

#include <span>
#include <vector>

#include "solvers/lanes/instruction_set.hpp"

namespace gcs {

class DistanceSystem;  // solvers/model/distance_system.hpp

/// Entries of a matrix that are differences of coordinates, which are numbered 3·point + axis; the others are 0.
struct DifferenceMatrix {
  struct Entry {
    int row = 0;
    int column = 0;
    int minuend = 0;
    int subtrahend = 0;
  };

  int rows = 0;
  int columns = 0;
  std::vector<Entry> entries;  ///< row by row
};

/// The Jacobian of f_i (DistanceSystem). Precondition: no line.
DifferenceMatrix difference_matrix(const DistanceSystem& system);

/// Three coordinates of every point, point by point.
struct PointCoordinates {
  const double* real = nullptr;
  const double* imaginary = nullptr;  ///< null: all 0
};

/// Of each figure the 2-norm condition number of the matrix, its rows normalised, to the digits that
/// rounding leaves. Infinite where it is above 1e18 or no number. The bits are the same whatever the instructions and
/// the other figures are. Preconditions: rows, columns ≥ 1; the instruction set is available.
std::vector<double> normalised_conditions(const DifferenceMatrix& matrix,
                                          std::span<const PointCoordinates> figures,
                                          InstructionSet set = widest_instruction_set());

}  // namespace gcs
