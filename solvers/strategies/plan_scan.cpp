/// Scans a construction plan's driving parameters for real solutions.
///
/// Hoffmann and Yuan solve n − k equations for given values of k parameters and scan what the other k leave
/// over a grid. A construction plan is such a parametrisation ([H] §5 with the plans of [I]); here its
/// parameters are angles (scanning/scan_plan.hpp). Hoffmann, Yuan, On Spatial Constraint Solving Approaches,
/// 2000, §5.
///
/// method=certified (the default) has, in place of a grid with a threshold, a subdivision of the range with
/// enclosures until every piece is proven to hold no solution or exactly one (scanning/plan_scan.hpp). What
/// is found is therefore proven, for the exact decimals of the file, and nothing depends on a width chosen
/// beforehand: all real solutions. It refuses scenes with more than most_angles driving parameters, of which
/// each multiplies the cells by hundreds, and gives up where solutions are not isolated or where they are
/// multiple; the ranges that it could not decide are named, and points of them that satisfy the constraints
/// to rounding are reported. Of general scenes it places points, lines and planes (construction/closed_forms.hpp,
/// scanning/element_subdivision.hpp). Of points and one line it refuses the line: on some scenes the derived plan leaves
/// angles undecided at which there is no solution.
///
/// method=published is theirs, for any number of parameters, with a line or without (scanning/grid_scan.hpp):
/// at every point T of the grid each branch with ρ(T) = max |f_j| < delta over the removed constraints, in
/// lengths, is a coarse solution, from which Newton's method on the whole system starts. Deviations: the grid is taken once over
/// mirror images, and coarse solutions that refine to mirror images are one. It misses what lies between the
/// points of the grid, hence the claim: some real ones. Of general scenes (scanning/element_scan.hpp) equations of any kind that the plan does not use close the
/// scan. There it also starts where the surfaces of an instruction miss each other by little.

#include "solvers/strategies/plan_scan.hpp"

#include <cmath>
#include <numbers>

#include "solvers/model/reframed_scene.hpp"
#include "solvers/scanning/element_scan.hpp"
#include "solvers/scanning/element_subdivision.hpp"
#include "solvers/scanning/grid_scan.hpp"
#include "solvers/scanning/plan_scan.hpp"
#include "solvers/scanning/scan_report.hpp"

namespace gcs {
namespace {

class PlanScanStrategy final : public Strategy {
 public:
  explicit PlanScanStrategy(const PlanScan& asked) : asked_(asked) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    if (places_elements(scene)) return why_no_plan_of_elements(in_frame_of_elements(scene));
    if (const auto reason = why_no_scan_plan(scene)) return reason;
    return is_published() ? std::nullopt : why_too_many(derive_scan_plan(scene).ranges.size());
  }

  void prepare(const SolveRequest& request) override {
    if (!places_elements(request.scene)) plan_ = derive_scan_plan(request.scene);
  }

  SolveReport solve(const SolveRequest& request) override {
    if (places_elements(request.scene)) {
      const Scene scene = in_frame_of_elements(request.scene);
      return scan_elements(request.on(scene));
    }
    const ScanPlan plan = plan_ ? *plan_ : derive_scan_plan(request.scene);
    if (is_published()) return grid_scan(request, plan, grid(request.scene, plan.ranges));
    return scan_report(request.scene, plan.ranges.size(), scan_plan(request, plan, asked_.scan.max_cells));
  }

 private:
  bool is_published() const { return asked_.method == PlanScan::Method::published; }

  /// The scan as published knows a line.
  bool places_elements(const Scene& scene) const {
    return scene.problem().is_general() || (scene.has_lines() && !is_published());
  }

  std::optional<std::string> why_no_plan_of_elements(const Scene& scene) const {
    if (auto reason = why_no_element_plan(scene, Instructions::all_places)) return reason;
    if (is_published()) return std::nullopt;
    const ElementPlan plan = derive_element_plan(scene, Instructions::all_places);
    if (auto reason = why_too_many(plan.ranges.size())) return reason;
    return why_no_element_subdivision(scene, plan);
  }

  SolveReport scan_elements(const SolveRequest& request) const {
    const ElementPlan plan = derive_element_plan(request.scene, Instructions::all_places);
    if (is_published()) return element_scan(request, plan, grid(request.scene, plan.ranges));
    return scan_report(request.scene, plan.ranges.size(),
                       subdivide_element_plan(request, plan, asked_.scan.max_cells));
  }

  std::optional<std::string> why_too_many(std::size_t angles) const {
    if (angles <= static_cast<std::size_t>(asked_.most_angles)) return std::nullopt;
    return "the derived plan has " + std::to_string(angles) + " driving parameters, and it scans at most " +
           std::to_string(asked_.most_angles);
  }

  GridScan grid(const Scene& scene, const std::vector<std::array<double, 2>>& ranges) const {
    GridScan scan;
    for (const std::array<double, 2>& range : ranges)
      scan.angles.push_back(grid_over(range, asked_.start, asked_.step));
    scan.delta = asked_.delta ? std::ldexp(*asked_.delta, -scene.unit_exponent())
                              : scene.size() * asked_.step * std::numbers::pi / 180;
    scan.max_points = asked_.max_points;
    return scan;
  }

  PlanScan asked_;
  std::optional<ScanPlan> plan_;
};

}  // namespace

StrategyEntry plan_scan_entry() {
  StrategyEntry entry = entry_of<PlanScanStrategy, PlanScan>();
  entry.summary =
      "subdivides the driving angles of a construction plan until every piece is decided, with proof";
  entry.citation = "Hoffmann, Yuan 2000, section 5";
  entry.knows_general_scenes = true;
  return entry;
}

}  // namespace gcs
