#include "solvers/tangents/scene_spheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "solvers/model/distance_system.hpp"
#include "solvers/model/given_numbers.hpp"
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

bool needs_isotropic_coordinates(const FourSpheres& in_scene, const ComplexTangent& line) {
  return relative_width(in_scene) < narrow || nearness_to_isotropic(line.direction) < narrow * narrow;
}

/// `line`: its point the one nearest to the first centre.
void refine_in_strip(const FourSpheres& in_scene, const ComplexTangent& line, bool is_real,
                     ComplexLine& result, WorkCounters& work) {
  const Strip strip(in_scene);
  const auto refined = refined_in_strip(in_scene, strip, ScaledLine::of(strip, line), work);
  if (!refined) return;
  const ComplexTangent polished = is_real ? real_part(refined->line) : refined->line;
  result = {polished.point, polished.direction};
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
    const int point = a == line ? b : a;
    if (!scene.fixed_point(point) || count == spheres.size()) return std::nullopt;
    Sphere& sphere = spheres[count++];
    sphere.square = squares[i];
    for (int axis = 0; axis < 3; ++axis) {
      const DoubleDouble exact = nearest_double_double(given_coordinate(scene, point, axis));
      sphere.center[axis] = exact.hi;
      sphere.center_rest[axis] = exact.lo;
    }
  }
  return count == spheres.size() ? std::optional(spheres) : std::nullopt;
}

Figure beside_given_points(const Scene& scene, const ComplexLine& line, bool is_real) {
  ComplexPoints points(3, scene.point_count());
  for (int i = 0; i < scene.point_count(); ++i)
    points.col(i) = scene.fixed_point(i)->cast<std::complex<double>>();
  return figure_of(points, {line}, is_real);
}

LocalSpheres::LocalSpheres(const FourSpheres& in_scene) : spheres(in_scene), origin(in_scene[0].center) {
  double reach = 0;
  for (Sphere& sphere : spheres) {
    for (int axis = 0; axis < 3; ++axis) {
      const DoubleDouble from_first = sphere.coordinate(axis) - in_scene[0].coordinate(axis);
      sphere.center[axis] = from_first.hi;
      sphere.center_rest[axis] = from_first.lo;
    }
    reach = std::max({reach, sphere.center.norm(), std::sqrt(sphere.square.value())});
  }
  if (reach > 0) exponent = std::ilogb(reach);
  for (Sphere& sphere : spheres) {
    for (Eigen::Vector3d* part : {&sphere.center, &sphere.center_rest})
      *part = part->unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
    sphere.square = {std::ldexp(sphere.square.hi, -2 * exponent),
                     std::ldexp(sphere.square.lo, -2 * exponent)};
  }
}

ComplexTangent LocalSpheres::local(const ComplexLine& line) const {
  const ComplexLine moved = normalised({line.point - origin, line.direction});
  return {moved.point * std::ldexp(1.0, -exponent), moved.direction};
}

ComplexTangent LocalSpheres::moved(const ComplexTangent& line) const {
  return {line.point * std::ldexp(1.0, exponent) + origin, line.direction};
}

ComplexLine LocalSpheres::in_scene(const ComplexTangent& line) const {
  const ComplexTangent there = moved(line);
  return normalised({there.point, there.direction});
}

ComplexLine polished(const FourSpheres& in_scene, const LocalSpheres& local, const ComplexTangent& line,
                     bool is_real, int multiplicity, WorkCounters& work) {
  ComplexLine result = local.in_scene(line);
  if (multiplicity > 1) {
    const auto found = multiple_tangent(local.spheres, line, is_real, multiplicity);
    if (found) result = local.in_scene(found->line);
  } else if (needs_isotropic_coordinates(in_scene, line)) {
    refine_in_strip(in_scene, local.moved(line), is_real, result, work);
  } else if (is_real) {
    refine_in_scene<double>(in_scene, {result.point.real(), result.direction.real()}, result, work);
  } else {
    refine_in_scene<std::complex<double>>(in_scene, {result.point, result.direction}, result, work);
  }
  return result;
}

}  // namespace gcs
