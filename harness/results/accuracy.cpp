#include "harness/results/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "harness/results/median_interval.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// What is further than this of the scene's size from every solution is none.
constexpr double farthest = 1e-3;

/// How far from a solution of condition 1 an answer may be to be that one and not another, in unit roundoffs.
constexpr double uncertainty = 10;

/// The digits that the reference has more than a refined answer, so that its own error does not show.
constexpr int spare_digits = 10;

DecimalFigure with_digits(const Scene& scene, const Figure& figure, int digits) {
  auto exact = decimal_figure(SceneEquations(scene), scene, figure, digits + spare_digits);
  if (!exact) throw std::runtime_error("a solution of the reference is not proven to so many digits");
  return std::move(*exact);
}

}  // namespace

AccuracyJudge::AccuracyJudge(const Scene& scene, ReferenceList reference)
    : scene_(scene),
      reference_(std::move(reference)),
      images_(mirror_images(scene)),
      reach_(reference_.solutions.size(), farthest * scene.size()) {
  for (std::size_t i = 0; i < reach_.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const double half = least_distance(reference_.solutions[i].figure, reference_.solutions[j].figure,
                                         images_, scene.size()) /
                          2;
      reach_[i] = std::min(reach_[i], half);
      reach_[j] = std::min(reach_[j], half);
    }
}

/// What rounding can do to an answer is no reason to call it another solution.
AccuracyJudge::Match AccuracyJudge::match(const AssessedSolution& solution,
                                          const std::vector<bool>& met) const {
  const double blur =
      std::min(farthest, uncertainty * std::max(1.0, solution.condition) * unit_roundoff) * scene_.size();
  Match best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < reach_.size(); ++i)
    for (const AxisSigns& signs : images_) {
      if (met[i]) continue;
      const double distance =
          largest_distance(solution.figure, reference_.solutions[i].figure, signs, scene_.size());
      if (distance > std::max(reach_[i], blur) || distance >= nearest) continue;
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
    case Claim::all_real_of_component:
    case Claim::all_real:
      return reference_.solutions[known].figure.is_real();
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
  const KnownSolution& known = reference_.solutions[static_cast<std::size_t>(match.known)];
  const bool is_refined = !run.refined.empty() && run.refined[solution];
  const double size = std::ldexp(scene_.size(), scene_.unit_exponent());
  const double distance = is_refined
                              ? largest_distance(*run.refined[solution],
                                                 with_digits(scene_, known.figure, digits), match.signs, size)
                              : largest_distance(decimals_of(run.solutions[solution].placement()),
                                                 known.exact, match.signs, size);
  return distance / size;
}

bool AccuracyJudge::is_search_in_vain(const SolveRun& run) const {
  const bool is_search = run.claim == Claim::some_real || run.claim == Claim::all_real_of_component;
  return is_search && run.status == RunStatus::gave_up && reference_.is_real_proven &&
         std::ranges::none_of(reference_.solutions,
                              [](const KnownSolution& known) { return known.figure.is_real(); });
}

Accuracy AccuracyJudge::judge(const SolveRun& run, int digits) const {
  Accuracy accuracy;
  std::vector<bool> met(reach_.size(), false);
  std::vector<double> errors;
  for (std::size_t i = 0; i < run.solutions.size(); ++i) {
    const AssessedSolution& solution = run.solutions[i];
    const Match first = match(solution, met);
    if (first.known < 0) {
      const bool is_duplicate = match(solution, std::vector<bool>(met.size(), false)).known >= 0;
      if (is_duplicate || is_scored(solution.figure)) ++accuracy.spurious;
      continue;
    }
    met[static_cast<std::size_t>(first.known)] = true;
    for (int more = 1; more < solution.multiplicity; ++more)
      if (const Match next = match(solution, met); next.known >= 0)
        met[static_cast<std::size_t>(next.known)] = true;
    errors.push_back(error(run, i, first, digits));
    const double condition = std::max(1.0, solution.condition);
    accuracy.largest_condition = std::max(accuracy.largest_condition, condition);
    accuracy.largest_quotient =
        std::max(accuracy.largest_quotient, errors.back() / (condition * unit_roundoff));
  }
  accuracy.met = static_cast<std::uint64_t>(std::count(met.begin(), met.end(), true));
  if (run.claim) accuracy.missed = missed(met, *run.claim);
  if (errors.empty()) return accuracy;
  accuracy.largest_error = *std::max_element(errors.begin(), errors.end());
  accuracy.median_error = median_interval(errors).median;
  return accuracy;
}

}  // namespace gcs
