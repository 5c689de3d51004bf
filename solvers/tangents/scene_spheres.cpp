#include "solvers/tangents/scene_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solvers/model/distance_system.hpp"
#include "solvers/tangents/strip_refinement.hpp"
#include "solvers/tangents/tangent_refinement.hpp"

namespace gcs {
namespace {

/// Moves the line where Newton's method converges.
template <class Scalar>
void refine_in_scene(const FourSpheres& in_scene, Tangent<Scalar> line, ComplexLine& result,
                     WorkCounters& work) {
  const TangentRefinement refinement = refine(in_scene, line);
  work.newton_iterations += refinement.iterations;
  if (!refinement.is_regular) return;
  result.point = line.point.template cast<std::complex<double>>();
  result.direction = line.direction.template cast<std::complex<double>>();
}

bool needs_isotropic_coordinates(const FourSpheres& in_scene, const ComplexLine& line) {
  return relative_width(in_scene) < narrow || nearness_to_isotropic(line.direction) < narrow * narrow;
}

void refine_in_strip(const FourSpheres& in_scene, bool is_real, ComplexLine& result, WorkCounters& work) {
  const Strip strip(in_scene);
  const auto refined =
      refined_in_strip(in_scene, strip, ScaledLine::of(strip, {result.point, result.direction}), work);
  if (!refined) return;
  const ComplexTangent line = is_real ? real_part(*refined) : *refined;
  result = {line.point, line.direction};
}

}  // namespace

std::optional<FourSpheres> spheres_of(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  const int line = scene.point_count();
  if (problem.lines.size() != 1 || problem.is_fixed(line)) return std::nullopt;
  const std::vector<DoubleDouble> squares = target_squares(scene);
  FourSpheres spheres;
  std::size_t count = 0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    const auto [a, b] = problem.constraints[i].between;
    if (a != line && b != line) continue;
    const std::optional<Eigen::Vector3d> center = scene.fixed_point(a == line ? b : a);
    if (!center || count == spheres.size()) return std::nullopt;
    spheres[count++] = {*center, squares[i]};
  }
  return count == spheres.size() ? std::optional(spheres) : std::nullopt;
}

LocalSpheres::LocalSpheres(const FourSpheres& in_scene) : spheres(in_scene), origin(in_scene[0].center) {
  double reach = 0;
  for (Sphere& sphere : spheres) {
    sphere.center -= origin;
    reach = std::max({reach, sphere.center.norm(), std::sqrt(sphere.square.value())});
  }
  if (reach > 0) exponent = std::ilogb(reach);
  for (Sphere& sphere : spheres) {
    sphere.center = sphere.center.unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
    sphere.square = {std::ldexp(sphere.square.hi, -2 * exponent),
                     std::ldexp(sphere.square.lo, -2 * exponent)};
  }
}

ComplexTangent LocalSpheres::local(const ComplexLine& line) const {
  const ComplexLine moved = normalised({line.point - origin, line.direction});
  return {moved.point * std::ldexp(1.0, -exponent), moved.direction};
}

ComplexLine LocalSpheres::in_scene(const ComplexTangent& line) const {
  return normalised({line.point * std::ldexp(1.0, exponent) + origin, line.direction});
}

ComplexLine polished(const FourSpheres& in_scene, const ComplexLine& line, bool is_real, int multiplicity,
                     WorkCounters& work) {
  ComplexLine result = normalised(line);
  if (multiplicity > 1) {
    const LocalSpheres local(in_scene);
    const auto found = multiple_tangent(local.spheres, local.local(line), is_real, multiplicity);
    if (found) result = local.in_scene(found->line);
  } else if (needs_isotropic_coordinates(in_scene, result)) {
    refine_in_strip(in_scene, is_real, result, work);
  } else if (is_real) {
    refine_in_scene<double>(in_scene, {result.point.real(), result.direction.real()}, result, work);
  } else {
    refine_in_scene<std::complex<double>>(in_scene, {result.point, result.direction}, result, work);
  }
  return result;
}

}  // namespace gcs
