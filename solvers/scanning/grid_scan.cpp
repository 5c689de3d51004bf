#include "solvers/scanning/grid_scan.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/scanning/step_places.hpp"

namespace gcs {
namespace {

/// Of what Newton's method has settled to: the coordinates' rounding leaves 1e-15 or so of a length.
constexpr double solved_residual = 1e-13;

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

  GridSlice run() {
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
  GridSlice slice_;
};

}  // namespace

SolveReport grid_scan(const SolveRequest& request, const ScanPlan& plan, const GridScan& asked) {
  const Surroundings with{request, plan, asked};
  return scan_slices(
      request, asked, with.no_solutions(), [&](std::int64_t number) { return SliceScan(with, number).run(); },
      [&](const RefinedSolutions& refined) {
        std::vector<Candidate> candidates;
        for (const Eigen::VectorXd& x : refined.list()) candidates.push_back({with.system.figure(x), 1});
        return candidates;
      });
}

}  // namespace gcs
