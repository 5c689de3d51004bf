#include "solvers/exploring/solution_graph.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

#include "solvers/exploring/explored_scene.hpp"
#include "solvers/exploring/random_starts.hpp"
#include "solvers/figures/residual_and_condition.hpp"

namespace gcs {

/// The class of each figure among the solutions and then these figures, in order of appearance.
std::vector<int> SolutionGraph::known(const std::vector<Figure>& figures,
                                      const std::vector<SolutionAccuracy>& accuracies) const {
  std::vector<Figure> all = representatives_;
  all.insert(all.end(), figures.begin(), figures.end());
  std::vector<SolutionAccuracy> of_all = accuracies_;
  of_all.insert(of_all.end(), accuracies.begin(), accuracies.end());
  const ReflectionClasses classes = solution_classes(scene_, all, of_all);
  return {classes.class_of.begin() + size(), classes.class_of.end()};
}

/// Nothing where it is singular. What is stiff is a solution, or next to one, only where that is proven.
std::optional<Candidate> SolutionGraph::settled(const Candidate& candidate, double condition) {
  const bool is_singular = condition > singular_solution_condition;
  if (condition < stiff_condition) return candidate;
  if (is_singular && neighbours_.is_hopeless()) return std::nullopt;
  const double error =
      is_singular ? std::numeric_limits<double>::infinity() : neighbours_.error_of(candidate.figure);
  if (std::isfinite(error)) return Candidate{candidate.figure, candidate.multiplicity, error};
  return neighbours_.nearest(candidate.figure);
}

/// Condition numbers, which cost the most, are taken of what is not seen at once to be known.
std::vector<int> SolutionGraph::take(const std::vector<Candidate>& found) {
  std::vector<Figure> figures;
  std::vector<SolutionAccuracy> accuracies;
  for (const Candidate& candidate : found) {
    figures.push_back(scene_.representative(candidate.figure));
    accuracies.push_back({0, candidate.error});
  }
  std::vector<int> numbers = known(figures, accuracies);
  std::vector<std::size_t> unknown;
  std::vector<Candidate> new_solutions;
  std::vector<Figure> new_figures;
  std::vector<SolutionAccuracy> new_accuracies;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (numbers[i] < size()) continue;
    numbers[i] = -1;
    if (relative_residual(scene_, figures[i]) > double_root_residual) continue;
    accuracies[i].condition = jacobian_condition(scene_, figures[i]);
    std::optional<Candidate> solution = settled(found[i], accuracies[i].condition);
    if (!solution) {
      ++singular_;
      continue;
    }
    figures[i] = scene_.representative(solution->figure);
    accuracies[i].error = solution->error;
    unknown.push_back(i);
    new_solutions.push_back(std::move(*solution));
    new_figures.push_back(figures[i]);
    new_accuracies.push_back(accuracies[i]);
  }
  if (unknown.empty()) return numbers;
  const std::vector<int> classes = known(new_figures, new_accuracies);
  for (std::size_t k = 0; k < unknown.size(); ++k) {
    const std::size_t i = unknown[k];
    numbers[i] = classes[k];
    if (classes[k] < size()) continue;
    solutions_.push_back(std::move(new_solutions[k]));
    representatives_.push_back(figures[i]);
    accuracies_.push_back(accuracies[i]);
    walked_.emplace_back(values_, false);
    walks_from_.push_back(0);
  }
  return numbers;
}

void SolutionGraph::mark(int solution, std::size_t value) {
  auto walked = walked_[static_cast<std::size_t>(solution)].begin() + static_cast<std::ptrdiff_t>(value);
  if (*walked) return;
  *walked = true;
  ++walks_from_[static_cast<std::size_t>(solution)];
}

void SolutionGraph::add_curve(std::size_t value, int start, CurveRecord curve,
                              const std::vector<int>& solution_of) {
  mark(start, value);
  std::vector<Crossing> crossings;
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < curve.path.crossings.size(); ++i) {
    const auto& [candidate, direction] = curve.path.crossings[i];
    const int solution = solution_of[static_cast<std::size_t>(candidate)];
    if (solution < 0) continue;
    if (!curve.places.empty()) places.push_back(curve.places[i]);
    mark(solution, value);
    if (solution != start) ++meetings_;
    crossings.push_back({solution, direction});
  }
  curve.path.crossings = std::move(crossings);
  curve.places = std::move(places);
  curves_.push_back(std::move(curve));
}

double SolutionGraph::walked_part() const {
  const double all = static_cast<double>(solutions_.size() * values_);
  return all > 0
             ? static_cast<double>(std::accumulate(walks_from_.begin(), walks_from_.end(), std::size_t{0})) /
                   all
             : 0;
}

}  // namespace gcs
