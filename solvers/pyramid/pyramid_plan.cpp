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

}  // namespace

ScanPlan pyramid_plan(const Scene& scene, const Pyramid& pyramid) {
  const ProblemStatement& problem = scene.problem();
  const int line = static_cast<int>(problem.points.size());
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
  const auto [p1, p2, p3, p4] = pyramid.cycle;
  const int apex = pyramid.apex;

  ScanPlan plan;
  plan.steps = {step(apex, {}), step(p1, {apex}), step(p2, {apex, p1}), step(p4, {apex, p1}),
                step(p3, {apex, p2})};
  plan.steps[0].freedom = 1;
  plan.steps[1].upper = true;
  plan.steps[4].checks = {sphere(p4, p3)};
  plan.ranges = {{-std::numbers::pi / 2, std::numbers::pi / 2}};
  plan.frame.line = line;
  plan.frame.height = apex;
  return plan;
}

}  // namespace gcs
