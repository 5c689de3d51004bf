#include "harness/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/median_interval.hpp"
#include "solvers/certification/scene_equations.hpp"

namespace gcs {
namespace {

/// What is further than this of the scene's size from every solution is none.
constexpr double farthest = 1e-3;

/// The digits that the reference has more than an answer, so that its own error does not show.
constexpr int spare_digits = 10;

/// Of an answer in doubles.
constexpr int digits_of_doubles = 17;

/// The mirror images of a class: none where positions are given.
std::vector<AxisSigns> mirror_images(const Scene& scene) {
  std::vector<AxisSigns> images;
  const int count = scene.is_anchored() ? 1 : 1 << scene.dimension();
  for (int mask = 0; mask < count; ++mask)
    images.push_back({(mask & 1) != 0 ? -1 : 1, (mask & 2) != 0 ? -1 : 1, (mask & 4) != 0 ? -1 : 1});
  return images;
}

std::vector<DecimalFigure> exact_figures(const Scene& scene, const std::vector<Figure>& figures, int digits,
                                         int threads) {
  std::vector<Figure> scaled;
  for (const Figure& figure : figures) scaled.push_back(scene.in_scene_unit(figure));
  std::vector<DecimalFigure> result;
  for (auto& exact : decimal_figures(SceneEquations(scene), scene, scaled, digits + spare_digits, threads)) {
    if (!exact) throw std::runtime_error("a solution of the reference is not proven to enough digits");
    result.push_back(std::move(*exact));
  }
  return result;
}

}  // namespace

AccuracyJudge::AccuracyJudge(const Scene& scene, ReferenceList reference, int threads)
    : scene_(scene),
      reference_(std::move(reference)),
      size_(std::ldexp(scene.size(), scene.unit_exponent())),
      exact_(exact_figures(scene, reference_.figures, digits_of_doubles, threads)),
      reach_(reference_.figures.size(), farthest * size_) {
  const std::vector<AxisSigns> images = mirror_images(scene_);
  for (std::size_t i = 0; i < reach_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      for (const AxisSigns& signs : images) {
        const double half = largest_distance(reference_.figures[i], reference_.figures[j], signs, size_) / 2;
        reach_[i] = std::min(reach_[i], half);
        reach_[j] = std::min(reach_[j], half);
      }
}

AccuracyJudge::Match AccuracyJudge::match(const Figure& figure) const {
  const std::vector<AxisSigns> images = mirror_images(scene_);
  Match best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < reach_.size(); ++i)
    for (const AxisSigns& signs : images) {
      const double distance = largest_distance(figure, reference_.figures[i], signs, size_);
      if (distance > reach_[i] || distance >= nearest) continue;
      nearest = distance;
      best = {static_cast<int>(i), signs};
    }
  return best;
}

/// Whether the reference can tell if this is a solution.
bool AccuracyJudge::is_scored(const Figure& figure) const {
  return figure.is_real() ? reference_.has_all_real : reference_.has_all_complex;
}

bool AccuracyJudge::is_expected(std::size_t known, Claim claim) const {
  switch (claim) {
    case Claim::on_path:
    case Claim::on_path_of_core:
      return (*reference_.on_path)[known];
    case Claim::some_real:
    case Claim::all_real:
      return reference_.figures[known].is_real();
    case Claim::all_complex:
      return true;
  }
  return true;
}

std::optional<std::uint64_t> AccuracyJudge::missed(const std::vector<bool>& met, Claim claim) const {
  const bool on_path = claim == Claim::on_path || claim == Claim::on_path_of_core;
  if (on_path ? !reference_.on_path : !reference_.has_all_real) return std::nullopt;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < met.size(); ++i)
    if (!met[i] && is_expected(i, claim)) ++count;
  return count;
}

double AccuracyJudge::error(const SolveRun& run, std::size_t solution, const Match& match, int digits) const {
  const auto known = static_cast<std::size_t>(match.known);
  const bool is_refined = !run.refined.empty() && run.refined[solution];
  if (!is_refined)
    return largest_distance(decimals_of(run.assessment.solutions[solution].figure), exact_[known],
                            match.signs, size_) /
           size_;
  const DecimalFigure exact = exact_figures(scene_, {reference_.figures[known]}, digits, 1).front();
  return largest_distance(*run.refined[solution], exact, match.signs, size_) / size_;
}

Accuracy AccuracyJudge::judge(const SolveRun& run, int digits) const {
  Accuracy accuracy;
  std::vector<bool> met(reach_.size(), false);
  std::vector<double> errors;
  for (std::size_t i = 0; i < run.assessment.solutions.size(); ++i) {
    const Figure& figure = run.assessment.solutions[i].figure;
    const Match found = match(figure);
    if (found.known < 0 || met[static_cast<std::size_t>(found.known)]) {
      if (found.known >= 0 || is_scored(figure)) ++accuracy.spurious;
      continue;
    }
    met[static_cast<std::size_t>(found.known)] = true;
    errors.push_back(error(run, i, found, digits));
  }
  accuracy.met = errors.size();
  if (run.claim) accuracy.missed = missed(met, *run.claim);
  if (errors.empty()) return accuracy;
  accuracy.largest_error = *std::max_element(errors.begin(), errors.end());
  accuracy.median_error = median_interval(errors).median;
  return accuracy;
}

}  // namespace gcs
