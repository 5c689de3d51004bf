#pragma once
/// From diagonals to coordinates.

#include <vector>

#include "solvers/model/complex_points.hpp"
#include "solvers/octahedron/diagonal_equations.hpp"

namespace gcs {

/// Places an octahedron on its triangle abc: a at the origin, b on the x-axis, c in the xy-plane; the other
/// points by trilateration, a' on one side only, the other being the mirror image. A plane is placed as the point a + n,
/// n its normal, which is the point n.
class OctahedronPlacer {
 public:
  /// `elements`: how many the figures have. Precondition: the triangle abc is not flat. Keeps references.
  OctahedronPlacer(int elements, const PairEntries& entries, const Octahedron& octahedron);

  /// a, b, c.
  std::array<int, 3> base() const {
    return {octahedron_.pair[0][0], octahedron_.pair[1][0], octahedron_.pair[2][0]};
  }

  /// Figures with these diagonals: as a rule one; two where a, a', b, b' are coplanar (c and c' on the same
  /// side or on opposite ones); more where nearly all is flat.
  std::vector<ComplexPoints> place(const Diagonals& diagonals);

 private:
  std::complex<double> square(int p, int q) const;
  std::optional<std::array<Eigen::Vector3cd, 2>> on(const std::array<int, 3>& centers, int p) const;
  void place_last(std::vector<ComplexPoints>& figures);
  double miss(const Eigen::Vector3cd& position, int p, int q) const;
  std::vector<Eigen::Vector3cd> plausible(const std::array<Eigen::Vector3cd, 2>& both, int p, int q) const;

  const PairEntries& entries_;
  const Octahedron& octahedron_;
  Diagonals diagonals_;
  ComplexPoints points_;
  double scale_ = 0;  ///< largest squared side of the base
};

}  // namespace gcs
