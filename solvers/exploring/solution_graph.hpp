#pragma once
/// Real solutions, up to what the scene counts as one, and the curves between them: a graph whose edges hold any number of
/// nodes.

#include <optional>
#include <vector>

#include "solvers/exploring/proven_neighbours.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

class SolutionGraph {
 public:
  /// `values`: how many values may be released. The scene outlives this.
  SolutionGraph(const Scene& scene, std::size_t values)
      : scene_(scene), values_(values), neighbours_(scene) {}

  /// The numbers of these solutions, new ones counted on; −1 of what is no solution to rounding, or singular.
  std::vector<int> take(const std::vector<Candidate>& found);
  /// A curve with a value released (its number among those that may be) that was walked from a solution. `solution_of`: of
  /// the candidates that its crossings name. All on it count as walked from.
  void add_curve(std::size_t value, int start, CurveRecord curve, const std::vector<int>& solution_of);

  int size() const { return static_cast<int>(solutions_.size()); }
  const std::vector<Candidate>& solutions() const { return solutions_; }
  const std::vector<CurveRecord>& curves() const { return curves_; }
  bool is_walked(int solution, std::size_t value) const {
    return walked_[static_cast<std::size_t>(solution)][value];
  }
  /// With so many values released curves were walked from it.
  std::size_t walked(int solution) const { return walks_from_[static_cast<std::size_t>(solution)]; }
  /// Part of all curves from all solutions that were walked, in [0, 1].
  double walked_part() const;
  /// How often a curve met a solution that it did not start from.
  std::int64_t meetings() const { return meetings_; }
  /// Points that were refused as singular.
  int singular() const { return singular_; }

 private:
  void mark(int solution, std::size_t value);
  std::optional<Candidate> settled(const Candidate& candidate, double condition);
  std::vector<int> known(const std::vector<Figure>& figures,
                         const std::vector<SolutionAccuracy>& accuracies) const;

  const Scene& scene_;
  std::size_t values_;
  std::vector<Candidate> solutions_;
  std::vector<Figure> representatives_;
  std::vector<SolutionAccuracy> accuracies_;
  std::vector<std::vector<bool>> walked_;  ///< by solution and value
  std::vector<std::size_t> walks_from_;    ///< of those, how many, by solution
  std::vector<CurveRecord> curves_;
  std::int64_t meetings_ = 0;
  int singular_ = 0;
  ProvenNeighbours neighbours_;
};

}  // namespace gcs
