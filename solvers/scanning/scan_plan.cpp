#include "solvers/scanning/scan_plan.hpp"

#include <algorithm>
#include <numbers>
#include <sstream>

#include "solvers/construction/derive.hpp"

namespace gcs {
namespace {

using std::numbers::pi;

/// All constraints between `point` and points placed before, in the order of placing.
std::vector<ScanSphere> known_spheres(const ProblemStatement& problem, int point,
                                      const std::vector<int>& placed) {
  std::vector<ScanSphere> known;
  for (const int center : placed)
    for (std::size_t c = 0; c < problem.constraints.size(); ++c) {
      const auto [a, b] = problem.constraints[c].between;
      if ((a == point && b == center) || (a == center && b == point))
        known.push_back({center, static_cast<int>(c)});
    }
  return known;
}

/// Angles around a centre: in the plane and on a circle one; on a sphere the longitude, then the latitude.
void append_ranges(const ScanStep& step, std::vector<std::array<double, 2>>& ranges) {
  const bool on_sphere = step.angles() == 2;
  if (on_sphere) {
    ranges.push_back({-pi, pi});
    ranges.push_back({step.upper ? 0 : -pi / 2, pi / 2});
  } else if (step.angles() == 1) {
    ranges.push_back({step.upper ? 0 : -pi, pi});
  }
}

Reference frame_of(const std::vector<ScanStep>& steps) {
  Reference frame;
  if (steps.empty() || steps[0].freedom > 0) return frame;
  frame.origin = steps[0].place;
  if (steps.size() > 1) frame.axis = steps[1].place;
  if (steps.size() > 2) frame.plane = steps[2].place;
  return frame;
}

}  // namespace

ScanPlan derive_scan_plan(const Scene& scene) {
  ScanPlan plan;
  std::vector<int> placed;
  for (int p = 0; p < scene.point_count(); ++p)
    if (scene.fixed_point(p)) placed.push_back(p);
  for (const int point : placing_order(scene)) {
    const int before = static_cast<int>(placed.size());
    ScanStep step;
    step.place = point;
    step.freedom = scene.is_anchored() ? scene.dimension() : std::min(before, scene.dimension());
    step.upper = !scene.is_anchored() && before >= 2 && before == step.freedom;
    step.first_angle = plan.angles();
    for (const ScanSphere& sphere : known_spheres(scene.problem(), point, placed)) {
      const bool takes_a_coordinate = static_cast<int>(step.spheres.size()) < step.freedom;
      (takes_a_coordinate ? step.spheres : step.checks).push_back(sphere);
    }
    append_ranges(step, plan.ranges);
    placed.push_back(point);
    plan.steps.push_back(std::move(step));
  }
  plan.frame = frame_of(plan.steps);
  return plan;
}

std::string describe_scan_plan(const Scene& scene, const ScanPlan& plan) {
  const auto id = [&scene](const ScanSphere& s) { return scene.problem().constraints[s.constraint].id; };
  std::ostringstream text;
  for (const ScanStep& step : plan.steps) {
    text << scene.problem().points[step.place];
    for (std::size_t i = 0; i < step.spheres.size(); ++i)
      text << (i == 0 ? " on " : ", ") << id(step.spheres[i]);
    for (int i = 0; i < step.angles(); ++i) text << ", angle " << step.first_angle + i + 1;
    for (const ScanSphere& check : step.checks) text << "; " << id(check) << " checked";
    text << '\n';
  }
  return text.str();
}

}  // namespace gcs
