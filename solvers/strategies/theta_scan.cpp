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

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/interface/options.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/pyramid/pyramid_branches.hpp"
#include "solvers/pyramid/pyramid_plan.hpp"
#include "solvers/scanning/scan_report.hpp"

namespace gcs {
namespace {

constexpr std::string_view methods = "events|published";

/// Of what Newton's method has settled to: the coordinates' rounding leaves 1e-15 or so of a length.
constexpr double solved_residual = 1e-13;

/// Relative to the scene's size. Newton's method ends at the same solution to about 1e-15 times its
/// condition.
constexpr double same_solution = 1e-9;

struct GridOptions {
  double step = 1;     ///< degrees
  double start = 0;    ///< degrees
  double delta = 0.2;  ///< in the file's unit

  explicit GridOptions(const OptionMap& options)
      : step(number_option(options, "dtheta", 1e-4, 360)),
        start(number_option(options, "start", -360, 360)),
        delta(number_option(options, "delta", 0, 1e300)) {}

  /// Angles from `start` on that are less than a full turn away; a quotient within rounding of a whole number
  /// is that number.
  int angles() const { return static_cast<int>(std::ceil(360 / step * (1 - 1e-12))); }
  double angle(int i) const { return (start + i * step) * std::numbers::pi / 180; }
};

class PublishedScan {
 public:
  PublishedScan(const SolveRequest& request, const Pyramid& pyramid, const GridOptions& options)
      : request_(request),
        scene_(request.scene),
        pyramid_(pyramid),
        options_(options),
        system_(scene_),
        squares_(target_squares(scene_)) {}

  SolveReport run() {
    const double delta = std::ldexp(options_.delta, -scene_.unit_exponent());
    const PyramidBranches branches(pyramid_);
    report_.status = SolveStatus::complete;
    for (int i = 0; i < options_.angles() && !is_stopped(); ++i) {
      show_progress(i);
      ++report_.work.evaluations;
      for (const PyramidBranch& branch : branches.at(options_.angle(i)))
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

  void show_progress(int angle) const {
    if (request_.monitor != nullptr)
      request_.monitor->progress("scanning", static_cast<double>(angle) / options_.angles());
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
  const GridOptions& options_;
  DistanceSystem system_;
  std::vector<DoubleDouble> squares_;
  std::vector<Eigen::VectorXd> refined_;
  std::int64_t coarse_ = 0;
  std::int64_t diverged_ = 0;
  SolveReport report_;
};

class ThetaScan final : public Strategy {
 public:
  explicit ThetaScan(const OptionMap& options)
      : is_published_(choice_option(options, "method", methods) == 1),
        options_(options),
        max_cells_(read_max_cells(options)) {}

  std::optional<std::string> why_unsupported(const Scene& scene) const override {
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
    if (is_published_) return PublishedScan(request, *pyramid, options_).run();
    const ScanPlan plan = pyramid_plan(request.scene, *pyramid);
    return scan_report(request.scene, plan, scan_plan(request.scene, plan, max_cells_, request.stop));
  }

 private:
  bool is_published_;
  GridOptions options_;
  std::int64_t max_cells_;
};

std::vector<OptionSpec> option_specs() {
  std::vector<OptionSpec> specs{
      {"method", "events", methods, "events: subdivision with proof; published: the paper's scan"},
      {"dtheta", "1", "number from 1e-4 to 360", "published: step of the angle, in degrees"},
      {"start", "0", "number from -360 to 360", "published: first angle, in degrees"},
      {"delta", "0.2", "number >= 0",
       "published: how near d34(theta) must come to d34, in the file's unit of length", true}};
  for (const OptionSpec& spec : scan_option_specs()) specs.push_back(spec);
  return specs;
}

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
  StrategyEntry entry;
  entry.name = "theta-scan";
  entry.summary = "scans five points and a line (5p1L) over the angle of one point around the line";
  entry.citation = "Hoffmann, Yuan 2000, section 4.3";
  entry.options = option_specs();
  entry.accuracy_settings = published_settings();
  entry.make = [](const OptionMap& options) -> std::unique_ptr<Strategy> {
    return std::make_unique<ThetaScan>(options);
  };
  return entry;
}

}  // namespace gcs
