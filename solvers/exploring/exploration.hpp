#pragma once
/// Walks from solution to solution until no curve is left.
///
/// In each round one curve for every value that has any left is walked, from the solution that was found first, so that no
/// two of a round are the same and their number does not depend on the threads. A journal has S, the rounds, and the random
/// starts.

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

  bool has_path() const;
  void find_first();
  void walk_all();
  bool start_anew();
  bool may_go_on() const;
  std::vector<Walk> next_round();
  void walk(const std::vector<Walk>& round);
  void take(const std::vector<Walk>& round, Reports reports);
  void take(const SolveReport& found);
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
  std::vector<int> next_;  ///< of each of them, the first solution that it may not have been released at
  SolutionGraph graph_;
  WorkCounters work_;
  int started_ = 0;          ///< random starts
  int singular_starts_ = 0;  ///< of these, so many end at singular points
  std::string first_doubt_;  ///< why a curve may have met more
};

}  // namespace gcs
