#include "solvers/octahedron/octahedron_with_planes.hpp"

#include "solvers/numeric/bilinear_product.hpp"
#include "solvers/octahedron/octahedron_placer.hpp"

namespace gcs {
namespace {

/// Of elements as OctahedronPlacer places them.
class FigureOfElements {
 public:
  FigureOfElements(const Scene& scene, const PairEntries& entries, const Octahedron& octahedron)
      : scene_(scene), entries_(entries), octahedron_(octahedron) {}

  Figure operator()(const ComplexPoints& placed) const {
    const ComplexPoints framed = in_frame(placed, 3, scene_.reference());
    Figure figure = complex_figure(framed.leftCols(scene_.point_count()));
    for (int plane = scene_.point_count(); plane < static_cast<int>(framed.cols()); ++plane) {
      const auto [a, b] = std::pair(octahedron_.pair[0][0], octahedron_.pair[1][0]);
      const Eigen::Vector3cd normal = framed.col(plane) - framed.col(a);
      const int point = plane == octahedron_.pair[0][1] ? b : a;  // a distance that is given
      const std::complex<double> offset =
          bilinear_product(normal, Eigen::Vector3cd(framed.col(point))) - entries_(plane, point);
      figure.planes.push_back({normal.real(), offset.real()});
      figure.imaginary_planes.push_back({normal.imag(), offset.imag()});
    }
    return figure;
  }

 private:
  const Scene& scene_;
  const PairEntries& entries_;
  const Octahedron& octahedron_;
};

}  // namespace

PlacedOctahedra place_with_planes(const Scene& scene, const Octahedron& octahedron, DiagonalMethod method) {
  const PairEntries entries(scene);
  const Octahedron round = with_round_base(octahedron, entries);
  const DiagonalEquations equations(entries, round);
  const DiagonalZeros found = diagonal_zeros(scene, round, equations, method);
  PlacedOctahedra result{equations.total_degree(), found.zeros.common_factor, found.elimination, {}};
  OctahedronPlacer placer(scene.problem().entity_count(), entries, round);
  const FigureOfElements figure(scene, entries, round);
  for (const std::vector<CommonZero>& zeros : found.zeros.of_eigenvalue)
    for (const CommonZero& zero : zeros)
      for (const ComplexPoints& placed : placer.place(equations.diagonals(zero)))
        if (placed.allFinite()) result.figures.push_back(figure(placed));
  return result;
}

}  // namespace gcs
