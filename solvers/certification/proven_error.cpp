#include "solvers/certification/proven_error.hpp"

#include <limits>

#include "solvers/certification/krawczyk.hpp"
#include "solvers/model/quality.hpp"
#include "solvers/model/wide_reference.hpp"

namespace gcs {

double proven_error(const Scene& scene, const std::vector<DoubleDouble>& squares, const Figure& figure) {
  constexpr double largest_box = 1e-6;
  constexpr int most_unknowns = 300;  // the test takes time cubic in them
  double error = std::numeric_limits<double>::infinity();
  if (!figure.is_real() || scene.has_lines()) return error;
  const DistanceSystem system(scene, wide_reference(scene));
  if (system.unknowns() > most_unknowns || !is_stiff(scene, figure)) return error;
  const Eigen::VectorXd x = system.coordinates(scene.in_frame(figure, system.reference()));
  for (double radius = largest_box * scene.size(); radius > 0x1p-52 * scene.size(); radius /= 8) {
    const Box box{x, Eigen::VectorXd::Constant(x.size(), radius)};
    if (krawczyk(system, squares, box) == BoxContent::one_solution) error = 2 * radius;  // 2 > √3
  }
  return error;
}

}  // namespace gcs
