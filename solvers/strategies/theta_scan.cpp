/// Five points and a line (5p1L): real solutions by scanning one angle.
///
/// With the line on the x-axis and the apex on the z-axis, p1 turns around the line by θ. At a given θ all
/// other points follow, on up to 128 branches, if the side p3–p4 is left open: d34(θ) is then a curve, and a
/// solution is where a branch of it meets the given d34. Hoffmann, Yuan, On Spatial Constraint Solving
/// Approaches, 2000, section 4.3.
///
/// method=events (the default) subdivides the range of θ with enclosures, following every branch, until each
/// piece is proven to hold no solution or exactly one (scanning/plan_scan.hpp; pyramid/pyramid_plan.hpp is
/// the plan). Pieces become as fine as they must where a branch ends or d34(θ) has an extremum, so that
/// nothing depends on a step or a threshold: all real solutions are found, except in pieces named as
/// undecided, where one is multiple or nearly so.
///
/// method=published is theirs: at θ = start, start + dtheta, … every branch with |d34(θ) − d34| < delta is a
/// coarse solution, from which Newton's method on the twelve equations (7) starts; equal ends are one refined
/// solution. (Their text has d34(θ) < δ for this.) The thirteenth equation, of the apex and the line, holds
/// from the start. Deviation: residuals are taken in double-double. It can miss solutions where the curve
/// touches the given length or a branch ends between two angles, and Newton's method may end elsewhere than
/// it began; hence the claim: some real ones.
///
/// Which point of the cycle plays p1 follows the file's order of points, and with it which side is open.

#include "solvers/strategies/theta_scan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solvers/pyramid/pyramid_plan.hpp"
#include "solvers/scanning/grid_scan.hpp"
#include "solvers/scanning/plan_scan.hpp"
#include "solvers/scanning/scan_report.hpp"

namespace gcs {
namespace {

/// Their scan: over all mirror images, which the twelve equations tell apart.
GridScan published_scan(const Scene& scene, const ThetaScan& asked) {
  const AngleGrid whole = grid_over({0, 2 * std::numbers::pi}, 0, asked.dtheta);
  return {.angles = {{asked.start, asked.dtheta, whole.count}},
          .delta = std::ldexp(asked.delta, -scene.unit_exponent()),
          .mirror_images_apart = true};
}

class ThetaScanStrategy final : public Strategy {
 public:
  explicit ThetaScanStrategy(const ThetaScan& asked) : asked_(asked) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    const auto pyramid = find_pyramid(scene);
    if (!pyramid)
      return "it solves 5p1L: a line at given distances from the apex and the four base points of a pyramid";
    const auto& radii = pyramid->radius;
    if (pyramid->apex_radius == 0 || std::find(radii.begin(), radii.end(), 0) != radii.end())
      return "a point lies on the line, where its equation is singular";
    return std::nullopt;
  }

  SolveReport solve(const SolveRequest& request) override {
    const auto pyramid = find_pyramid(request.scene);
    if (asked_.method == ThetaScan::Method::published)
      return grid_scan(request, pyramid_plan_with_images(request.scene, *pyramid),
                       published_scan(request.scene, asked_));
    const ScanPlan plan = pyramid_plan(request.scene, *pyramid);
    return scan_report(request.scene, plan.ranges.size(), scan_plan(request, plan, asked_.scan.max_cells));
  }

 private:
  ThetaScan asked_;
};

/// The published scan with coarse and fine steps, in narrow and wide bands.
std::vector<OptionMap> published_settings() {
  std::vector<OptionMap> settings;
  for (const char* step : {"1", "0.1", "0.01"})
    for (const char* band : {"0.1", "0.2", "1"})
      settings.push_back({{"method", "published"}, {"dtheta", step}, {"delta", band}});
  return settings;
}

}  // namespace

StrategyEntry theta_scan_entry() {
  StrategyEntry entry = entry_of<ThetaScanStrategy, ThetaScan>();
  entry.summary = "scans five points and a line (5p1L) over the angle of one point around the line";
  entry.citation = "Hoffmann, Yuan 2000, section 4.3";
  entry.accuracy_settings = published_settings();
  return entry;
}

}  // namespace gcs
