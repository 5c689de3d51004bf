#include "solvers/certificates/proven_error.hpp"

#include <limits>
#include <utility>

#include "solvers/certificates/krawczyk.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/wide_reference.hpp"

namespace gcs {

namespace {

// The tests take time cubic in the unknowns.
constexpr int most_unknowns = 300, most_unknowns_in_balls = 100;

double error_by_certificate(const Scene& scene, const Figure& figure) {
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (why_not_certified(scene) || !is_stiff(scene, figure)) return unknown;
  const SceneEquations equations(scene);
  QuadraticSystem system = equations.system();
  if (system.unknowns > most_unknowns_in_balls) return unknown;
  const Figure framed = scene.in_frame(figure);
  const Certificate certificate = Certifier(std::move(system)).certify(equations.coordinates(framed));
  return certificate.is_proven ? equations.distance(framed, certificate) : unknown;
}

}  // namespace

double proven_error(const Scene& scene, const std::vector<DoubleDouble>& squares, const Figure& figure) {
  constexpr double largest_box = 1e-6;
  double error = std::numeric_limits<double>::infinity();
  if (!figure.is_real() || scene.has_lines()) return error_by_certificate(scene, figure);
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
