#include "harness/sweeps/open_side_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/figures/reflection_classes.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/pyramid/pyramid_plan.hpp"

namespace gcs {
namespace {

/// Of what Newton's method has settled to: the coordinates' rounding leaves 1e-15 or so of a length.
constexpr double solved_residual = 1e-13;

/// Relative to the scene's size: far above the rounding of a solution, and below the distance of two that are
/// told apart by Newton's method in double.
constexpr double same_solution = 1e-9;

std::vector<Figure> distinct(const Scene& scene, const std::vector<Figure>& figures) {
  std::vector<Figure> first;
  for (const int i : reflection_classes(scene, figures, same_solution).first) first.push_back(figures[i]);
  return first;
}

/// What the default finds.
std::vector<Figure> real_figures(const SolveRun& run) {
  std::vector<Figure> figures;
  for (const AssessedSolution& solution : run.solutions)
    if (solution.is_real()) figures.push_back(solution.figure);
  return figures;
}

/// Largest difference of distances between points, least over all pairs of figures.
double closest_pair(const Scene& scene, const std::vector<Figure>& figures) {
  double closest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < figures.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      double difference = 0;
      for (int p = 0; p < scene.point_count(); ++p)
        for (int q = 0; q < p; ++q) {
          const auto distance = [p, q](const Figure& f) {
            return (f.points.col(p) - f.points.col(q)).norm();
          };
          difference = std::max(difference, std::abs(distance(figures[i]) - distance(figures[j])));
        }
      closest = std::min(closest, difference / scene.size());
    }
  return closest;
}

}  // namespace

FineScan::FineScan(const ProblemStatement& problem, int angles) : problem_(problem) {
  const Scene scene(problem);
  const Pyramid pyramid = *find_pyramid(scene);
  open_side_ = pyramid_plan(scene, pyramid).steps.back().checks.front().constraint;
  curve_ = sample_gap_curve(pyramid, angles);
  for (GapSample& sample : curve_) sample.gap = std::ldexp(sample.gap, scene.unit_exponent());
  std::sort(curve_.begin(), curve_.end(),
            [](const GapSample& a, const GapSample& b) { return a.gap < b.gap; });
}

ProblemStatement FineScan::with_length(double length) const {
  ProblemStatement problem = problem_;
  problem.constraints[open_side_].given = {length, fmt::format("{}", length)};
  return problem;
}

std::vector<Figure> FineScan::solutions(double length, double band) const {
  const Scene scene(with_length(length));
  const Pyramid pyramid = *find_pyramid(scene);
  const PyramidBranches branches(pyramid);
  const DistanceSystem system(scene);
  const std::vector<DoubleDouble> squares = target_squares(scene);
  const double scene_band = std::ldexp(band, -scene.unit_exponent());
  const auto is_below = [](const GapSample& sample, double gap) { return sample.gap < gap; };
  std::vector<Figure> figures;
  auto sample = std::lower_bound(curve_.begin(), curve_.end(), length - band, is_below);
  for (; sample != curve_.end() && sample->gap < length + band; ++sample)
    for (const PyramidBranch& branch : branches.at(sample->theta * std::numbers::pi / 180)) {
      if (!(std::abs(branch.gap() - pyramid.side[2]) < scene_band)) continue;
      Eigen::VectorXd x = system.coordinates(scene.in_frame(figure_of(pyramid, branch), system.reference()));
      if (!refine(system, squares, x).converged) continue;
      const Figure figure = system.figure(x);
      if (relative_residual(scene, figure) <= solved_residual) figures.push_back(figure);
    }
  return distinct(scene, figures);
}

OpenSideVerdict check_open_side(const FineScan& scan, double length, double band) {
  const Scene scene(scan.with_length(length));
  const SolveRun run = run_strategy(find_strategy("theta-scan"), {}, scene, {});
  std::vector<Figure> figures = real_figures(run);
  const std::vector<Figure> finer = scan.solutions(length, band);
  OpenSideVerdict verdict;
  verdict.length = length;
  verdict.is_complete = run.status == RunStatus::complete && run.failed_checks.empty();
  verdict.solutions = figures.size();
  verdict.finer = finer.size();
  verdict.closest = closest_pair(scene, figures);
  figures.insert(figures.end(), finer.begin(), finer.end());
  verdict.together = distinct(scene, figures).size();
  return verdict;
}

}  // namespace gcs
