#pragma once
/// Where elements are, as complex numbers with the bilinear form p·q = Σ p_i q_i.

#include <array>
#include <complex>
#include <vector>

#include "solvers/model/complex_lines.hpp"
#include "solvers/model/complex_points.hpp"

namespace gcs {

/// normal·x = offset with normal·normal = 1.
struct ComplexPlane {
  Eigen::Vector3cd normal;
  std::complex<double> offset;
};

/// The same side of the same plane with a normal of length 1; as it is where normal·normal = 0.
ComplexPlane normalised(const ComplexPlane& plane);

/// In space; in the plane z = 0. A line by its point with point·direction = 0, direction·direction = 1.
struct Placement {
  ComplexPoints points;
  std::vector<ComplexLine> lines;
  std::vector<ComplexPlane> planes;
  /// Segments, the smaller number of a point first, whose directions point from their ends to their starts.
  std::vector<std::array<int, 2>> turned_segments{};
};

/// The elements of a figure, real or not, its lines normalised.
Placement placement_of(const Figure& figure);
/// The figure of a placement or, where it is real, of its real parts. A plane with a direction of its own, as `turned`
/// says, has the sign that lines have.
Figure figure_of(const Placement& placement, bool is_real, const std::vector<bool>& turned);

}  // namespace gcs
