#include "solvers/certificates/proven_error.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "solvers/certificates/certificate_member.hpp"
#include "solvers/certificates/krawczyk.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/figures/complex_distances.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/distance_system.hpp"
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
  return certified_error(equations, Certifier(std::move(system)), scene.in_frame(figure));
}

/// Nothing where it is not proven to be complex, or too far away.
std::optional<Candidate> solution_next_to(const Scene& scene, const SceneEquations& equations,
                                          const std::vector<std::complex<double>>& x,
                                          const Certificate& certificate) {
  constexpr double longest_way = 1e-3;  // relative to 1 + the largest coordinate
  if (!certificate.is_proven || certificate.realness != Certificate::Realness::not_real) return std::nullopt;
  double size = 1, moved = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    size = std::max(size, std::abs(x[i]));
    moved = std::max(moved, certificate.offset(i, x[i]));
  }
  if (!(moved <= longest_way * size)) return std::nullopt;
  const DistanceSystem system(scene);
  Figure rounded = complex_figure(
      system, Eigen::Map<const Eigen::VectorXcd>(certificate.enclosure.mid.data(), system.unknowns()));
  const double error = equations.distance(rounded, certificate);
  return Candidate{std::move(rounded), 1, error};
}

}  // namespace

double certified_error(const SceneEquations& equations, const Certifier& certifier, const Figure& framed) {
  const Certificate certificate = certifier.certify(equations.coordinates(framed));
  return certificate.is_proven ? equations.distance(framed, certificate)
                               : std::numeric_limits<double>::infinity();
}

std::vector<std::optional<Candidate>> proven_next_to(const Scene& scene,
                                                     const std::vector<const Figure*>& figures,
                                                     const SolveMeans& means) {
  constexpr int precise_bits = 128;
  std::vector<std::optional<Candidate>> proven(figures.size());
  if (figures.empty() || scene.has_lines() || why_not_certified(scene)) return proven;
  const SceneEquations equations(scene);
  if (equations.system().unknowns > most_unknowns_in_balls) return proven;
  const auto point_of = [&](std::size_t i) { return equations.coordinates(*figures[i]); };
  certify_points(
      Certifier(equations.system()), figures.size(), point_of,
      {means.threads, nullptr, means.stop, means.crew},
      [&](std::size_t i, const Certificate& certificate) {
        proven[i] = solution_next_to(scene, equations, point_of(i), certificate);
      },
      precise_bits);
  return proven;
}

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
