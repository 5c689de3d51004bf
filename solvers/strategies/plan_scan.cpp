/// Scans a construction plan's driving parameters for all real solutions.
///
/// Hoffmann and Yuan solve n − k equations for given values of k parameters and scan what the other k leave
/// over a grid. A construction plan is such a parametrisation ([H] §5 with the plans of [I]); here its
/// parameters are angles (scanning/scan_plan.hpp), and in place of a grid with a threshold the range is
/// subdivided with enclosures until every piece is proven to hold no solution or exactly one
/// (scanning/plan_scan.hpp). What is found is therefore proven, for the exact decimals of the file, and
/// nothing depends on a width chosen beforehand.
///
/// It fails on scenes with more than two driving parameters, and gives up where solutions are not isolated or
/// where they are multiple; the ranges that it could not decide are named, and points of them that satisfy
/// the constraints to rounding are reported. Hoffmann, Yuan, On Spatial Constraint Solving Approaches, 2000,
/// §5.

#include "solvers/strategies/plan_scan.hpp"

#include "solvers/construction/derive.hpp"
#include "solvers/scanning/scan_report.hpp"

namespace gcs {
namespace {

constexpr int most_angles = 2;  // each more multiplies the cells by hundreds

class PlanScanStrategy final : public Strategy {
 public:
  explicit PlanScanStrategy(const PlanScan& asked) : max_cells_(asked.scan.max_cells) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    if (scene.has_lines()) return "its plans place points only, and the instance has a line";
    if (const auto reason = why_no_plan(scene)) return reason;
    const int angles = derive_scan_plan(scene).angles();
    if (angles <= most_angles) return std::nullopt;
    return "the derived plan has " + std::to_string(angles) + " driving parameters, and it scans at most " +
           std::to_string(most_angles);
  }

  void prepare(const SolveRequest& request) override { plan_ = derive_scan_plan(request.scene); }

  SolveReport solve(const SolveRequest& request) override {
    const ScanPlan plan = plan_ ? *plan_ : derive_scan_plan(request.scene);
    return scan_report(request.scene, plan, scan_plan(request.scene, plan, max_cells_, request.stop));
  }

 private:
  std::int64_t max_cells_;
  std::optional<ScanPlan> plan_;
};

}  // namespace

StrategyEntry plan_scan_entry() {
  StrategyEntry entry = entry_of<PlanScanStrategy, PlanScan>();
  entry.summary =
      "subdivides the driving angles of a construction plan until every piece is decided, with proof";
  entry.citation = "Hoffmann, Yuan 2000, section 5";
  return entry;
}

}  // namespace gcs
