#include "solvers/scanning/grid_scan.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <mutex>
#include <numbers>
#include <sstream>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/running/run_on_threads.hpp"
#include "solvers/scanning/refined_solutions.hpp"
#include "solvers/scanning/step_places.hpp"

namespace gcs {
namespace {

/// Of what Newton's method has settled to: the coordinates' rounding leaves 1e-15 or so of a length.
constexpr double solved_residual = 1e-13;

/// What the grid points of one value of the first angle give.
struct Slice {
  RefinedSolutions refined;
  std::int64_t coarse = 0;
  std::int64_t diverged = 0;
  std::int64_t newton_iterations = 0;
};

/// All that slices have in common.
struct Surroundings {
  const SolveRequest& request;
  const ScanPlan& plan;
  const GridScan& asked;
  StepPlaces places{request.scene, plan};
  DistanceSystem system{request.scene, plan.frame};
  std::vector<DoubleDouble> squares{target_squares(request.scene)};

  RefinedSolutions no_solutions() const {
    std::vector<int> axes = mirror_axes(request.scene, system);
    if (asked.mirror_images_apart) std::fill(axes.begin(), axes.end(), -1);
    return {std::move(axes), same_solution * request.scene.size()};
  }
};

/// Follows all branches at one value of the first angle.
class SliceScan {
 public:
  SliceScan(const Surroundings& with, std::int64_t number)
      : with_(with),
        number_(number),
        points_(Eigen::Matrix3Xd::Zero(3, with.request.scene.point_count())),
        placings_(static_cast<std::size_t>(with.request.scene.point_count())),
        known_(with.plan.steps.size()),
        slice_{with.no_solutions()} {
    for (int p = 0; p < with.request.scene.point_count(); ++p)
      if (const auto position = with.request.scene.fixed_point(p)) points_.col(p) = *position;
  }

  Slice run() {
    follow(0);
    return std::move(slice_);
  }

 private:
  bool is_over() const { return with_.request.stop.stop_requested(); }

  void follow(std::size_t k) {
    if (k == with_.plan.steps.size()) return refine_coarse();
    const ScanStep& step = with_.plan.steps[k];
    if (step.angles() == 0) return place(k, {});
    const auto first = static_cast<std::size_t>(step.first_angle);
    over(first, [&](double angle) {
      if (step.angles() == 1) return place(k, {angle, 0});
      over(first + 1, [&](double other) { place(k, {angle, other}); });
    });
  }

  /// Calls for every value of the angle, of the first one for that of this slice.
  template <class Call>
  void over(std::size_t angle, const Call& call) const {
    const AngleGrid& grid = with_.asked.angles[angle];
    if (angle == 0) return call(grid.at(number_));
    for (std::int64_t i = 0; i < grid.count && !is_over(); ++i) call(grid.at(i));
  }

  void place(std::size_t k, const std::array<double, 2>& angles) {
    const ScanStep& step = with_.plan.steps[k];
    for (const Eigen::Vector3d& position : places(k, angles)) {
      const bool is_in_band =
          std::all_of(step.checks.begin(), step.checks.end(), [&](const ScanSphere& check) {
            return with_.places.excess(check, position, points_) < with_.asked.delta;
          });
      if (!is_in_band) continue;
      points_.col(step.place) = position;
      placings_[static_cast<std::size_t>(step.place)] = ++placing_;
      follow(k + 1);
    }
  }

  /// Without an angle of its own, a step has the same places while its centres stay.
  Places places(std::size_t k, const std::array<double, 2>& angles) {
    const ScanStep& step = with_.plan.steps[k];
    if (step.angles() > 0) return with_.places.of(k, points_, angles);
    std::array<std::int64_t, 3> centers{};
    for (std::size_t i = 0; i < step.spheres.size(); ++i)
      centers[i] = placings_[static_cast<std::size_t>(step.spheres[i].center)];
    Known& known = known_[k];
    if (known.centers != centers) known = {centers, with_.places.of(k, points_, angles)};
    return known.places;
  }

  void refine_coarse() {
    ++slice_.coarse;
    Eigen::VectorXd x = with_.system.coordinates(Figure{points_, {}});
    const Refinement refinement = refine(with_.system, with_.squares, x);
    slice_.newton_iterations += refinement.iterations;
    if (refinement.converged &&
        relative_residual(with_.request.scene, with_.system.figure(x)) <= solved_residual)
      slice_.refined.take(x);
    else
      ++slice_.diverged;
  }

  /// The places of a step when its centres were placed in these placings.
  struct Known {
    std::array<std::int64_t, 3> centers{-1, -1, -1};
    Places places;
  };

  const Surroundings& with_;
  std::int64_t number_;
  Eigen::Matrix3Xd points_;
  std::vector<std::int64_t> placings_;  ///< by point: which placing put it where it is; 0: it is fixed
  std::int64_t placing_ = 0;
  std::vector<Known> known_;  ///< by step
  Slice slice_;
};

/// Takes slices in their order, whichever thread brings them when.
class GridScanRun {
 public:
  GridScanRun(const SolveRequest& request, const ScanPlan& plan, const GridScan& asked)
      : with_{request, plan, asked}, all_{with_.no_solutions()} {
    if (!asked.angles.empty()) slices_ = asked.angles.front().count;
  }

  SolveReport run() {
    const auto threads = static_cast<int>(std::min<std::int64_t>(slices_, with_.request.threads));
    run_on_threads(std::max(1, threads), [this](int) {
      for (std::int64_t number = begun_++; number < slices_; number = begun_++) {
        if (with_.request.stop.stop_requested()) break;
        bring(number, SliceScan(with_, number).run());
      }
    });
    return report();
  }

 private:
  void bring(std::int64_t number, Slice slice) {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(number, std::move(slice));
    for (auto next = waiting_.begin(); next != waiting_.end() && next->first == taken_;
         next = waiting_.erase(next), ++taken_)
      take(next->second);
    if (with_.request.monitor != nullptr)
      with_.request.monitor->progress("scanning", static_cast<double>(taken_) / static_cast<double>(slices_));
  }

  void take(const Slice& slice) {
    all_.coarse += slice.coarse;
    all_.diverged += slice.diverged;
    all_.newton_iterations += slice.newton_iterations;
    for (const Eigen::VectorXd& x : slice.refined.list()) all_.refined.take(x);
  }

  SolveReport report() const {
    SolveReport report;
    report.claim = Claim::some_real;
    report.status = SolveStatus::complete;
    if (with_.request.stop.stop_requested()) {
      report.status = SolveStatus::stopped;
      report.reason = "stopped on request";
    }
    for (const Eigen::VectorXd& x : all_.refined.list())
      report.candidates.push_back({with_.system.figure(x), 1});
    report.work.evaluations = taken_;
    for (std::size_t i = 1; i < with_.asked.angles.size(); ++i)
      report.work.evaluations *= with_.asked.angles[i].count;
    report.work.newton_iterations = all_.newton_iterations;
    report.particulars = {{"driving_parameters", with_.plan.angles()},
                          {"coarse_solutions", all_.coarse},
                          {"coarse_without_solution", all_.diverged},
                          {"refined_solutions", static_cast<std::int64_t>(all_.refined.list().size())}};
    return report;
  }

  Surroundings with_;
  std::int64_t slices_ = 1;
  std::atomic<std::int64_t> begun_{0};
  std::mutex mutex_;  ///< of all below
  std::map<std::int64_t, Slice> waiting_;
  std::int64_t taken_ = 0;
  Slice all_;
};

}  // namespace

double AngleGrid::at(std::int64_t i) const {
  return (first + static_cast<double>(i) * step) * std::numbers::pi / 180;
}

AngleGrid grid_over(const std::array<double, 2>& range, double start, double step) {
  constexpr double degree = std::numbers::pi / 180;
  const double width = (range[1] - range[0]) / degree - start;
  const double steps = std::ceil(width / step * (1 - 1e-12));
  return {range[0] / degree + start, step, static_cast<std::int64_t>(std::max(0.0, steps))};
}

std::optional<SolveReport> refused_grid(const GridScan& asked) {
  double points = 1;
  for (const AngleGrid& grid : asked.angles) points *= static_cast<double>(grid.count);
  if (points > 0 && points <= static_cast<double>(asked.max_points)) return std::nullopt;
  std::ostringstream reason;
  if (points == 0)
    reason << "the grid is empty: an angle's range ends before its first value";
  else
    reason << "the grid has " << points << " points, more than max_points allows; a wider step makes fewer";
  SolveReport report;
  report.claim = Claim::some_real;
  report.status = SolveStatus::gave_up;
  report.reason = reason.str();
  return report;
}

SolveReport grid_scan(const SolveRequest& request, const ScanPlan& plan, const GridScan& asked) {
  if (auto refused = refused_grid(asked)) return *refused;
  return GridScanRun(request, plan, asked).run();
}

}  // namespace gcs
