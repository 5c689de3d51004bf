#include "harness/sweeps/explore_check.hpp"

#include <algorithm>
#include <functional>

#include "harness/results/strategy_choice.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/figures/reflection_classes.hpp"

namespace gcs {
namespace {

/// Relative to the scene's size: far above the rounding of a solution, and below the distance of two.
constexpr double same_solution = 1e-7;

SolveRun run(const ProblemStatement& problem, const char* strategy, const OptionMap& options, bool certify,
             double time_limit_s) {
  RunLimits limits;
  limits.certify = certify;
  limits.checks_counts = false;
  limits.time_limit_s = time_limit_s;
  return run_strategy(find_strategy(strategy), options, Scene(problem), limits);
}

std::vector<Figure> real_figures(const SolveRun& run) {
  std::vector<Figure> figures;
  for (const AssessedSolution& solution : run.solutions)
    if (solution.is_real()) figures.push_back(solution.figure);
  return figures;
}

class ExploreCheck {
 public:
  ExploreCheck(const ProblemStatement& problem, double time_limit_s)
      : problem_(problem), scene_(problem), time_limit_s_(time_limit_s) {}

  ExploreVerdict run_all() {
    const SolveRun all = run(problem_, "monodromy", {}, true, time_limit_s_);
    verdict_.why_not = all.reason;
    if (all.status != RunStatus::complete) return verdict_;
    real_ = real_figures(all);
    verdict_.real = real_.size();
    verdict_.is_proven = all.proofs && all.proofs->decide_real();
    verdict_.from_sketch = reach(explored(problem_, {{"starts", "0"}}));
    verdict_.with_starts = reach(explored(problem_, {}));
    find_components();
    return verdict_;
  }

 private:
  SolveRun explored(const ProblemStatement& problem, const OptionMap& options) const {
    return run(problem, "explore", options, false, time_limit_s_);
  }

  /// Which of the real solutions were found.
  std::vector<std::size_t> numbers_of(const SolveRun& run) {
    std::vector<Figure> figures = real_;
    for (const Figure& figure : real_figures(run)) figures.push_back(figure);
    const std::vector<int> class_of = reflection_classes(scene_, figures, same_solution).class_of;
    std::vector<std::size_t> numbers;
    for (std::size_t i = real_.size(); i < figures.size(); ++i) {
      const auto known = class_of.begin() + std::ssize(real_);
      const auto found = std::find(class_of.begin(), known, class_of[i]);
      if (found != known)
        numbers.push_back(static_cast<std::size_t>(found - class_of.begin()));
      else
        ++verdict_.unexpected;
    }
    return numbers;
  }

  ExploreReach reach(const SolveRun& run) {
    return {numbers_of(run).size(), std::ssize(run.curves), run.timing.cpu_s};
  }

  /// Each from its first solution, no length of which changes on the way from that sketch.
  void find_components() {
    std::vector<bool> is_known(real_.size());
    for (std::size_t first = 0; first < real_.size(); ++first) {
      if (is_known[first]) continue;
      ProblemStatement at_solution = problem_;
      at_solution.sketch = scene_.in_file_unit(real_[first]);
      at_solution.interpolation.bends.emplace();
      const std::vector<std::size_t> members = numbers_of(explored(at_solution, {{"starts", "0"}}));
      for (const std::size_t member : members) is_known[member] = true;
      verdict_.components.push_back(members.size());
    }
    std::ranges::sort(verdict_.components, std::greater());
  }

  const ProblemStatement& problem_;
  const Scene scene_;
  double time_limit_s_;
  std::vector<Figure> real_;
  ExploreVerdict verdict_;
};

}  // namespace

ExploreVerdict check_explore(const ProblemStatement& problem, double time_limit_s) {
  return ExploreCheck(problem, time_limit_s).run_all();
}

std::vector<FoundSoFar> found_after(const ProblemStatement& problem, const std::string& strategy,
                                    const std::vector<double>& times_s) {
  std::vector<FoundSoFar> found;
  for (const double time_s : times_s) {
    const SolveRun stopped = run(problem, strategy.c_str(), {{"reduce", "off"}}, false, time_s);
    found.push_back({stopped.timing.cpu_s, real_figures(stopped).size()});
  }
  return found;
}

}  // namespace gcs
