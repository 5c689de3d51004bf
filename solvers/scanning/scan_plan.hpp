#pragma once
/// A construction plan made for scanning: the driving parameters are angles, so that each runs over an
/// interval known beforehand and its own instruction has no branch ends. [H] §5 with the plans of [I].

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solvers/model/scene.hpp"

namespace gcs {

/// A sphere (circle in the plane) on which a point lies: its centre's number and the constraint.
struct ScanSphere {
  int center = -1;
  int constraint = -1;
};

/// Places one point. The frame leaves it `freedom` coordinates; of these `spheres` and `cylinder` take one
/// each, and angles, numbered from `first_angle` on, the others.
struct ScanStep {
  int place = -1;
  int freedom = 0;
  std::vector<ScanSphere> spheres;
  int cylinder = -1;  ///< the constraint that gives the point's distance to the line, the x-axis; −1: none
  int first_angle = -1;
  /// Divides out the reflection: this is the first point that the frame's y-axis or, in space, z-axis sees,
  /// and its coordinate there is not negative; beside a line it is the second point, whose x and y are not.
  bool upper = false;
  std::vector<ScanSphere> checks;  ///< constraints with points placed before that take no coordinate

  int angles() const { return freedom - static_cast<int>(spheres.size()) - (cylinder >= 0 ? 1 : 0); }
};

struct ScanPlan {
  std::vector<ScanStep> steps;
  /// The range of each angle, in radians: a whole turn or half of one.
  std::vector<std::array<double, 2>> ranges;

  /// The frame in which the plan builds: its first points as origin, axis and plane (which the plane's own
  /// problems do not use), or a line and a height; nothing where positions are fixed.
  Reference frame;

  int angles() const { return static_cast<int>(ranges.size()); }
};

/// Why a scene has no such plan, in a sentence, or nothing.
std::optional<std::string> why_no_scan_plan(const Scene& scene);

/// The plan with the fewest angles that derive.hpp's order of points gives. With a line, the first point is at
/// its height on the z-axis, and the second leaves out mirror images. Precondition: a well posed problem,
/// nothing from why_no_scan_plan.
ScanPlan derive_scan_plan(const Scene& scene);

/// The plan in words, one point per line: "p4 on a2, a5 at an angle; a9 checked".
std::string describe_scan_plan(const Scene& scene, const ScanPlan& plan);

}  // namespace gcs
