#include "solvers/pyramid/pyramid_plan.hpp"

#include <algorithm>
#include <numbers>

namespace gcs {
namespace {

int constraint_between(const ProblemStatement& problem, int p, int q) {
  const auto joins = [p, q](const DistanceConstraint& c) {
    return (c.between[0] == p && c.between[1] == q) || (c.between[0] == q && c.between[1] == p);
  };
  const auto found = std::find_if(problem.constraints.begin(), problem.constraints.end(), joins);
  return static_cast<int>(found - problem.constraints.begin());
}

/// The line, the apex and p1 at the angle, mirror images not left out; then the points
/// that `others` has, each after those around which it lies. d34 is checked at the last one.
ScanPlan plan_of(const Scene& scene, const Pyramid& pyramid,
                 const std::array<std::array<int, 2>, 3>& others) {
  const ProblemStatement& problem = scene.problem();
  const int line = static_cast<int>(problem.points.size());
  const int apex = pyramid.apex;
  const auto sphere = [&](int around, int point) {
    return ScanSphere{around, constraint_between(problem, around, point)};
  };
  const auto step = [&](int point, const std::vector<int>& around) {
    ScanStep placing;
    placing.place = point;
    placing.freedom = 3;
    placing.cylinder = constraint_between(problem, line, point);
    placing.first_angle = 0;
    for (const int center : around) placing.spheres.push_back(sphere(center, point));
    return placing;
  };
  ScanPlan plan;
  plan.steps = {step(apex, {}), step(pyramid.cycle[0], {apex})};
  plan.steps[0].freedom = 1;
  for (const auto& [point, neighbour] : others) plan.steps.push_back(step(point, {apex, neighbour}));
  const int last = others[2][0];
  plan.steps.back().checks = {sphere(pyramid.cycle[2] + pyramid.cycle[3] - last, last)};
  plan.ranges = {{-std::numbers::pi, std::numbers::pi}};
  plan.frame.line = line;
  plan.frame.height = apex;
  return plan;
}

}  // namespace

ScanPlan pyramid_plan(const Scene& scene, const Pyramid& pyramid) {
  const auto [p1, p2, p3, p4] = pyramid.cycle;
  ScanPlan plan = plan_of(scene, pyramid, {{{p2, p1}, {p4, p1}, {p3, p2}}});
  plan.steps[1].upper = true;
  plan.ranges = {{-std::numbers::pi / 2, std::numbers::pi / 2}};
  return plan;
}

ScanPlan pyramid_plan_with_images(const Scene& scene, const Pyramid& pyramid) {
  const auto [p1, p2, p3, p4] = pyramid.cycle;
  return plan_of(scene, pyramid, {{{p2, p1}, {p3, p2}, {p4, p1}}});
}

}  // namespace gcs
