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

/// The constraint between the point and the line, or −1.
int cylinder_of(const ProblemStatement& problem, int point) {
  for (std::size_t c = 0; c < problem.constraints.size(); ++c) {
    const auto [a, b] = problem.constraints[c].between;
    if ((a == point && !problem.is_point(b)) || (b == point && !problem.is_point(a)))
      return static_cast<int>(c);
  }
  return -1;
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

/// Of the second point beside a line, whose mirror images have the other sign of x or y.
void append_quarter(const ScanStep& step, std::vector<std::array<double, 2>>& ranges) {
  if (step.angles() == 2) ranges.push_back({0, pi / 2});
  ranges.push_back({-pi / 2, pi / 2});
}

Reference frame_of(const Scene& scene, const std::vector<ScanStep>& steps) {
  Reference frame;
  if (scene.has_lines()) {
    frame.line = scene.point_count();
    frame.height = steps[0].place;
    return frame;
  }
  if (steps.empty() || steps[0].freedom > 0) return frame;
  frame.origin = steps[0].place;
  if (steps.size() > 1) frame.axis = steps[1].place;
  if (steps.size() > 2) frame.plane = steps[2].place;
  return frame;
}

/// Coordinates that the frame leaves to the next point when `before` are placed.
int freedom_of(const Scene& scene, int before) {
  if (scene.has_lines()) return before == 0 ? 1 : scene.dimension();
  return scene.is_anchored() ? scene.dimension() : std::min(before, scene.dimension());
}

}  // namespace

std::optional<std::string> why_no_scan_plan(const Scene& scene) {
  if (!scene.has_lines()) return why_no_plan(scene);
  const ProblemStatement& problem = scene.problem();
  if (problem.lines.size() > 1 || scene.is_anchored() || scene.dimension() != 3)
    return "its plans know one line, in space and where no positions are given";
  for (int point = 0; point < scene.point_count(); ++point)
    if (const int c = cylinder_of(problem, point); c >= 0 && !(scene.target_lengths()[c] > 0))
      return "a point lies on the line, where its equation is singular";
  if (placing_order(scene).empty())
    return "its plans place every point but one beside the line on a sphere around another point";
  return std::nullopt;
}

ScanPlan derive_scan_plan(const Scene& scene) {
  ScanPlan plan;
  std::vector<int> placed;
  for (int p = 0; p < scene.point_count(); ++p)
    if (scene.fixed_point(p)) placed.push_back(p);
  for (const int point : placing_order(scene)) {
    const int before = static_cast<int>(placed.size());
    const bool is_second_beside_line = scene.has_lines() && before == 1;
    ScanStep step;
    step.place = point;
    step.freedom = freedom_of(scene, before);
    step.cylinder = cylinder_of(scene.problem(), point);
    step.upper = is_second_beside_line ||
                 (!scene.has_lines() && !scene.is_anchored() && before >= 2 && before == step.freedom);
    step.first_angle = plan.angles();
    for (const ScanSphere& sphere : known_spheres(scene.problem(), point, placed))
      (step.angles() > 0 ? step.spheres : step.checks).push_back(sphere);
    if (is_second_beside_line)
      append_quarter(step, plan.ranges);
    else
      append_ranges(step, plan.ranges);
    placed.push_back(point);
    plan.steps.push_back(std::move(step));
  }
  plan.frame = frame_of(scene, plan.steps);
  return plan;
}

std::string describe_scan_plan(const Scene& scene, const ScanPlan& plan) {
  const auto id = [&scene](const ScanSphere& s) { return scene.problem().constraints[s.constraint].id; };
  std::ostringstream text;
  for (const ScanStep& step : plan.steps) {
    text << scene.problem().points[step.place];
    if (step.cylinder >= 0) text << " by " << scene.problem().constraints[step.cylinder].id;
    for (std::size_t i = 0; i < step.spheres.size(); ++i)
      text << (i == 0 ? " on " : ", ") << id(step.spheres[i]);
    for (int i = 0; i < step.angles(); ++i) text << ", angle " << step.first_angle + i + 1;
    for (const ScanSphere& check : step.checks) text << "; " << id(check) << " checked";
    text << '\n';
  }
  return text.str();
}

}  // namespace gcs
