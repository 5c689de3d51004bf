#include "solvers/figures/solution_classes.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/figures/general_figures.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// The condition that decides which solutions can be told apart. Complex ones are told apart by squared
/// distances or products of coordinates, whose rounding grows with the square of the coordinates, however
/// short the lengths.
double effective_condition(const Scene& scene, const Figure& representative, double condition) {
  if (representative.is_real()) return condition;
  const double stretch = std::max(1.0, extent(representative) / scene.size());
  return condition * stretch * stretch;
}

/// Beyond it Newton's method need not have converged as at a regular solution: near a double one the error is
/// the square root of the rounding, and the condition number that is found there its inverse.
constexpr double largest_regular_condition = 3e6;

/// Relative to the scene's size, from the proven error.
double proven_tolerance(const Scene& scene, const SolutionAccuracy& accuracy) {
  return std::max(64 * unit_roundoff, 4 * accuracy.error / scene.size());
}

/// Two candidates of the same class within proven errors: a distance moves by both ends', and the frame's
/// rounding is left. Places are known as well as that, or as the condition of a regular solution tells.
ClassTolerance tolerance_of(const Scene& scene, const Figure& representative,
                            const SolutionAccuracy& accuracy) {
  const double condition = effective_condition(scene, representative, accuracy.condition);
  const double proven = proven_tolerance(scene, accuracy);
  const double found = merging_tolerance(condition);
  ClassTolerance tolerance{std::min(proven, found)};
  if (std::isfinite(proven)) tolerance.places = proven;
  if (condition <= largest_regular_condition) tolerance.places = std::min(tolerance.places, found);
  return tolerance;
}

}  // namespace

double merging_tolerance(double condition) {
  return std::min(1e-5, std::max(1e-10, 2 * unit_roundoff * condition));
}

ReflectionClasses solution_classes(const Scene& scene, std::span<const Figure> representatives,
                                   std::span<const SolutionAccuracy> accuracies, int threads) {
  if (scene.problem().is_general()) {
    std::vector<GeneralTolerance> tolerances;
    for (const SolutionAccuracy& accuracy : accuracies)
      tolerances.push_back({merging_tolerance(accuracy.condition), accuracy.error});
    return general_classes(scene, representatives, tolerances);
  }
  std::vector<const Figure*> figures;
  std::vector<ClassTolerance> tolerances;
  for (std::size_t i = 0; i < representatives.size(); ++i) {
    figures.push_back(&representatives[i]);
    tolerances.push_back(tolerance_of(scene, representatives[i], accuracies[i]));
  }
  return reflection_classes(scene, figures, tolerances, threads);
}

}  // namespace gcs
