#include "solvers/homotopies/restated_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "solvers/certificates/proven_error.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/tangents/degenerate_spheres.hpp"
#include "solvers/tangents/scene_spheres.hpp"
#include "solvers/tangents/squeezed_tangents.hpp"

namespace gcs {
namespace {

/// Relative width of the centres (tangent_equations.hpp) below which lines have coordinates of 1e5 to 1e10 times the lengths
/// and more.
constexpr double too_narrow = 1e-5;

/// Those of four given points, which are all, that are nearly collinear and not quite.
std::optional<FourSpheres> narrow_spheres(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  for (int point = 0; point < scene.point_count(); ++point)
    if (!problem.is_fixed(point)) return std::nullopt;
  std::optional<FourSpheres> spheres = spheres_of(scene);
  if (!spheres || scene.point_count() != 4 || relative_width(*spheres) >= too_narrow ||
      why_nearly_concentric(*spheres))
    return std::nullopt;
  return spheres;
}

/// The scene with its points moved apart.
ProblemStatement widened(const Scene& scene, const FourSpheres& spheres) {
  ProblemStatement problem = scene.problem();
  const FourSpheres apart = Strip(spheres).widened_spheres();
  problem.fixed_texts.clear();
  for (std::size_t i = 0; i < apart.size(); ++i) {
    const auto [a, b] = problem.constraints[i].between;
    const auto point = static_cast<std::size_t>(problem.is_point(a) ? a : b);
    problem.fixed_points[point] =
        apart[i].center.unaryExpr([&](double x) { return std::ldexp(x, scene.unit_exponent()); });
  }
  return problem;
}

const Scene& solved(const Scene& given, const std::optional<Scene>& widened) {
  return widened ? *widened : given;
}

}  // namespace

std::optional<std::string> why_not_restated(const Scene& scene) {
  const std::optional<FourSpheres> spheres = narrow_spheres(scene);
  return why_not_released(spheres ? Scene::unchecked(widened(scene, *spheres)) : scene);
}

RestatedScene::RestatedScene(const Scene& given) : given_(given) {
  if (const auto spheres = narrow_spheres(given))
    widened_.emplace(Scene::unchecked(widened(given, *spheres)));
  released_.emplace(solved(given_, widened_));
}

SolveReport RestatedScene::carried_back(const SolveRequest& request, SolveReport report) const {
  std::vector<Candidate> candidates = std::exchange(report.candidates, {});
  for (Candidate& candidate : candidates)
    if (std::optional<Figure> figure = released_->carried_back(candidate.figure))
      report.candidates.push_back({*std::move(figure), candidate.multiplicity, candidate.error});
  if (report.generic) *report.generic >>= released_->doublings();
  report.generic_member.reset();
  report.escaping.clear();
  if (widened_) squeeze(request, report);
  const std::optional<FourSpheres> spheres = spheres_of(given_);
  const std::optional<LocalSpheres> local = spheres ? std::optional<LocalSpheres>(*spheres) : std::nullopt;
  const std::vector<DoubleDouble> squares = target_squares(given_);
  for (Candidate& candidate : report.candidates) {
    Figure& figure = candidate.figure;
    if (local) {
      const ComplexLine line = polished(*spheres, *local, local->local(complex_lines(figure).front()),
                                        figure.is_real(), candidate.multiplicity, report.work);
      figure = figure_of(complex_points(figure), {line}, figure.is_real());
    }
    if (candidate.multiplicity == 1) candidate.error = proven_error(given_, squares, figure);
  }
  return report;
}

/// From the lines of the widened scene to those of the given one.
void RestatedScene::squeeze(const SolveRequest& request, SolveReport& report) const {
  const LocalSpheres local(*spheres_of(given_));
  const double unit = std::ldexp(1.0, widened_->unit_exponent() - given_.unit_exponent());
  FoundTangents apart;
  for (const Candidate& candidate : report.candidates) {
    const ComplexLine line = complex_lines(candidate.figure).front();
    apart.lines.push_back({local.local({line.point * unit, line.direction}), candidate.figure.is_real(),
                           candidate.multiplicity});
  }
  std::mt19937_64 random(request.seed);
  const SqueezedTangents squeezed =
      squeezed_tangents(local.spheres, Strip(local.spheres), apart, random, report.work);
  report.candidates.clear();
  for (const FoundTangent& found : squeezed.found.lines) {
    const ComplexTangent line = local.moved(found.line);
    report.candidates.push_back({beside_given_points(given_, {line.point, line.direction}, found.is_real)});
  }
  const auto lost = std::ranges::count(squeezed.has_end, false);
  if (lost == 0 || report.status != SolveStatus::complete) return;
  report.status = SolveStatus::partial;
  report.reason = fmt::format(
      "{} of the {} lines beside points that are moved apart are lost on the way to where these are given",
      lost, apart.lines.size());
}

}  // namespace gcs
