/// Five points and a line (5p1L): real solutions by scanning one angle.
///
/// With the line on the x-axis and the apex on the z-axis, p1 turns around the line by θ. At a given θ all
/// other points follow, on up to 128 branches (pyramid/pyramid_branches.hpp), if the side p3–p4 is left open:
/// d34(θ) is then a curve, and a solution is where a branch of it meets the given d34. Hoffmann, Yuan, On
/// Spatial Constraint Solving Approaches, 2000, section 4.3.
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

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/pyramid/pyramid_branches.hpp"
#include "solvers/pyramid/pyramid_plan.hpp"
#include "solvers/scanning/scan_report.hpp"

namespace gcs {
namespace {

/// Of what Newton's method has settled to: the coordinates' rounding leaves 1e-15 or so of a length.
constexpr double solved_residual = 1e-13;

/// Relative to the scene's size. Newton's method ends at the same solution to about 1e-15 times its
/// condition.
constexpr double same_solution = 1e-9;

/// Angles from asked.start on that are less than a full turn away; a quotient within rounding of a whole
/// number is that number.
int angle_count(const ThetaScan& asked) {
  return static_cast<int>(std::ceil(360 / asked.dtheta * (1 - 1e-12)));
}

double angle(const ThetaScan& asked, int i) {
  return (asked.start + i * asked.dtheta) * std::numbers::pi / 180;
}

class PublishedScan {
 public:
  PublishedScan(const SolveRequest& request, const Pyramid& pyramid, const ThetaScan& asked)
      : request_(request),
        scene_(request.scene),
        pyramid_(pyramid),
        asked_(asked),
        angles_(angle_count(asked)),
        system_(scene_),
        squares_(target_squares(scene_)) {}

  SolveReport run() {
    const double delta = std::ldexp(asked_.delta, -scene_.unit_exponent());
    const PyramidBranches branches(pyramid_);
    report_.status = SolveStatus::complete;
    for (int i = 0; i < angles_ && !is_stopped(); ++i) {
      show_progress(i);
      ++report_.work.evaluations;
      for (const PyramidBranch& branch : branches.at(angle(asked_, i)))
        if (std::abs(branch.gap() - pyramid_.side[2]) < delta) refine_coarse(branch);
    }
    finish();
    return std::move(report_);
  }

 private:
  bool is_stopped() {
    if (!request_.stop.stop_requested()) return false;
    report_.status = SolveStatus::stopped;
    report_.reason = "stopped on request";
    return true;
  }

  void show_progress(int done) const {
    if (request_.monitor != nullptr)
      request_.monitor->progress("scanning", static_cast<double>(done) / angles_);
  }

  void refine_coarse(const PyramidBranch& coarse) {
    ++coarse_;
    Eigen::VectorXd x =
        system_.coordinates(scene_.in_frame(figure_of(pyramid_, coarse), system_.reference()));
    const Refinement refinement = refine(system_, squares_, x);
    report_.work.newton_iterations += refinement.iterations;
    if (refinement.converged && relative_residual(scene_, system_.figure(x)) <= solved_residual)
      keep_distinct(x);
    else
      ++diverged_;
  }

  void keep_distinct(const Eigen::VectorXd& x) {
    const double tolerance = same_solution * scene_.size();
    const bool known = std::any_of(refined_.begin(), refined_.end(), [&](const Eigen::VectorXd& other) {
      return (x - other).cwiseAbs().maxCoeff() <= tolerance;
    });
    if (!known) refined_.push_back(x);
  }

  void finish() {
    report_.claim = Claim::some_real;
    for (const Eigen::VectorXd& x : refined_) report_.candidates.push_back({system_.figure(x), 1});
    report_.particulars = {{"coarse_solutions", coarse_},
                           {"coarse_without_solution", diverged_},
                           {"refined_solutions", static_cast<std::int64_t>(refined_.size())}};
  }

  const SolveRequest& request_;
  const Scene& scene_;
  const Pyramid& pyramid_;
  const ThetaScan& asked_;
  int angles_;
  DistanceSystem system_;
  std::vector<DoubleDouble> squares_;
  std::vector<Eigen::VectorXd> refined_;
  std::int64_t coarse_ = 0;
  std::int64_t diverged_ = 0;
  SolveReport report_;
};

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
    if (asked_.method == ThetaScan::Method::published) return PublishedScan(request, *pyramid, asked_).run();
    const ScanPlan plan = pyramid_plan(request.scene, *pyramid);
    return scan_report(request.scene, plan,
                       scan_plan(request.scene, plan, asked_.scan.max_cells, request.stop));
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
