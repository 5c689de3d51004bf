#pragma once
/// Walks from solution to solution until no curve is left.
///
/// Which curve comes next is a bandit's choice: from the solution with the fewest curves walked, with the value whose last
/// curves led to the most new solutions (results/sweeps/order.md has what that gains). Curves are walked in rounds, of
/// different values, so that no two of a round are the same, and of a number that does not depend on the threads. A journal
/// has S, the rounds, and the random starts.

#include "solvers/exploring/curve_walk.hpp"
#include "solvers/exploring/explored_scene.hpp"
#include "solvers/exploring/solution_graph.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/numeric/digest.hpp"

namespace gcs {

struct ExplorationLimits {
  std::int64_t most_curves = 0;
  /// So many random starts are made when no curve is left, and once more each time that one leads to a new solution.
  int starts = 0;
  double unseen = 0;  ///< no more curves are walked when fewer classes than this are expected to be unseen
};

class Exploration {
 public:
  /// Precondition: !why_not_explored(request.scene). The request outlives this.
  Exploration(const SolveRequest& request, const WalkOptions& walks, const ExplorationLimits& limits);

  SolveReport run();

 private:
  using Reports = std::vector<SolveReport>;
  struct Walk {
    std::size_t value = 0;  ///< number among the equations that may be released
    int start = 0;
  };

  void find_first();
  void walk_all();
  bool start_anew();
  bool may_go_on() const;
  std::size_t round_size() const;
  std::vector<Walk> next_round() const;
  std::optional<std::size_t> best_value(int start, const std::vector<bool>& is_taken) const;
  void walk(const std::vector<Walk>& round);
  void take(const std::vector<Walk>& round, Reports reports);
  void take(const SolveReport& found);
  void learn(std::size_t value, int new_solutions);
  SolveReport report_on_starts() const;
  Reports recalled_or(const Digest& step, const std::function<Reports()>& compute);
  bool has_proven_components() const;
  SolveReport report() const;
  std::string shortcomings() const;

  const SolveRequest& request_;
  WalkOptions walks_;
  ExplorationLimits limits_;
  TrackerContext context_;
  std::unique_ptr<ExploredScene> explored_;
  std::vector<Eigen::Index> releasable_;  ///< equations that give a value
  std::vector<double> yield_;  ///< of each of them, new solutions for a curve, of the last curves mostly
  SolutionGraph graph_;
  WorkCounters work_;
  int started_ = 0;          ///< random starts
  int singular_starts_ = 0;  ///< of these, so many end at singular points
  std::string first_doubt_;  ///< why a curve may have met more
};

}  // namespace gcs
