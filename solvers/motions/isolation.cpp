#include "solvers/motions/isolation.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>

#include "solvers/certificates/scene_equations.hpp"
#include "solvers/model/complex_points.hpp"
#include "solvers/model/reframed_scene.hpp"
#include "solvers/motions/local_multiplicity.hpp"

namespace gcs {
namespace {

/// Relative to the largest: what is smaller counts as 0.
constexpr double vanishing = 1e-6;

/// The dimension of the space that the points span.
int span_of(const ComplexPoints& points) {
  const Eigen::JacobiSVD<Eigen::MatrixXcd> svd(points.colwise() - points.col(0));
  return static_cast<int>((svd.singularValues().array() > vanishing * svd.singularValues()[0]).count());
}

/// Of points none of which is the largest determinant of squared distances.
Reference widest_reference(const ComplexPoints& points, int dimension) {
  const auto square = [&](int a, int b) { return squared_distance(points, a, b); };
  const auto count = static_cast<int>(points.cols());
  Reference widest;
  double largest = 0;
  for (int a = 0; a < count; ++a)
    for (int b = a + 1; b < count; ++b)
      if (std::abs(square(a, b)) > largest) {
        largest = std::abs(square(a, b));
        widest = {a, b};
      }
  if (dimension == 2 || widest.axis < 0) return widest;
  largest = 0;
  for (int c = 0; c < count; ++c) {
    const std::complex<double> side = square(widest.origin, widest.axis), other = square(widest.origin, c),
                               product = (side + other - square(widest.axis, c)) / 2.0;
    const double area = std::abs(side * other - product * product);
    if (area > largest) {
      largest = area;
      widest.plane = c;
    }
  }
  return widest;
}

}  // namespace

bool can_be_isolated(const Scene& scene, const Figure& figure, int paths) {
  const auto is_alone = [](const Scene& framed, const Figure& in_frame, int most) {
    const SceneEquations equations(framed);
    const auto multiplicity = local_multiplicity(equations.system(), equations.coordinates(in_frame), most);
    return multiplicity && *multiplicity <= most;
  };
  if (scene.has_lines() || scene.is_anchored()) return is_alone(scene, figure, paths);
  const ComplexPoints points = complex_points(figure);
  const int span = span_of(points), dimension = scene.dimension();
  // Of points on a line the frame leaves two signs open, and any frame does.
  if (span < dimension - 1) return is_alone(scene, figure, 4 * paths);
  const Scene framed = with_reference(scene, widest_reference(points, dimension));
  const ComplexPoints in_frame = gcs::in_frame(points, dimension, framed.reference());
  return in_frame.allFinite() &&
         is_alone(framed, complex_figure(in_frame), span < dimension ? 2 * paths : paths);
}

}  // namespace gcs
