#include "solvers/structure/core_reduction.hpp"

#include <algorithm>
#include <set>

namespace gcs {

namespace {

/// n log n for n entities and constraints.
class Reducer {
 public:
  Reducer(const ProblemStatement& problem, const std::vector<int>& keep, HangsOn allowed)
      : problem_(problem),
        allowed_(allowed),
        neighbours_(problem.points.size() + problem.lines.size()),
        present_(neighbours_.size(), true),
        kept_(neighbours_.size(), false),
        left_(static_cast<int>(neighbours_.size())) {
    for (const int entity : keep) kept_[entity] = true;
    for (const DistanceConstraint& constraint : problem.constraints)
      for (const int side : {0, 1})
        neighbours_[constraint.between[side]].push_back(constraint.between[1 - side]);
  }

  CoreReduction run() {
    for (int point = 0; point < static_cast<int>(problem_.points.size()); ++point) update(point);
    while (left_ > smallest_rest() && !ready_.empty()) {
      const int point = ready_.rbegin()->second;
      result_.placed.push_back({point, neighbours(point)});
      remove(point);
    }
    std::reverse(result_.placed.begin(), result_.placed.end());
    list_core();
    return result_;
  }

 private:
  std::vector<int> neighbours(int entity) const {
    std::vector<int> result;
    for (const int other : neighbours_[entity])
      if (present_[other]) result.push_back(other);
    return result;
  }

  /// Entities that no rigid motion moves are needed to count degrees of freedom as before: d points, or a
  /// line and another entity; fixed positions do the same.
  int smallest_rest() const {
    if (anchored_) return 0;
    return problem_.lines.empty() ? problem_.dimension : 2;
  }

  bool can_go(int point) const {
    if (!present_[point] || problem_.is_fixed(point)) return false;
    const std::vector<int> from = neighbours(point);
    const auto is_point = [this](int entity) { return problem_.is_point(entity); };
    return static_cast<int>(from.size()) == problem_.dimension &&
           (allowed_ == HangsOn::entities || std::all_of(from.begin(), from.end(), is_point));
  }

  void update(int point) {
    const std::pair<bool, int> entry{!kept_[point], point};
    if (can_go(point))
      ready_.insert(entry);
    else
      ready_.erase(entry);
  }

  void remove(int point) {
    present_[point] = false;
    --left_;
    update(point);
    for (const int other : neighbours(point))
      if (problem_.is_point(other)) update(other);
  }

  void list_core() {
    bool only_fixed = true;
    for (int entity = 0; entity < static_cast<int>(present_.size()); ++entity) {
      if (!present_[entity]) continue;
      only_fixed = only_fixed && problem_.is_fixed(entity);
      result_.core.push_back(entity);
    }
    result_.core_is_trivial = only_fixed || (!anchored_ && left_ <= smallest_rest());
    for (int i = 0; i < static_cast<int>(problem_.constraints.size()); ++i) {
      const auto [a, b] = problem_.constraints[i].between;
      if (present_[a] && present_[b]) result_.core_constraints.push_back(i);
    }
  }

  const ProblemStatement& problem_;
  const HangsOn allowed_;
  std::vector<std::vector<int>> neighbours_;  ///< of every entity, in the order of the constraints
  std::vector<bool> present_;
  std::vector<bool> kept_;
  std::set<std::pair<bool, int>> ready_;  ///< points that can go, those to keep first
  int left_;
  bool anchored_ = problem_.is_anchored();
  CoreReduction result_;
};

}  // namespace

CoreReduction reduce_to_core(const ProblemStatement& problem, const std::vector<int>& keep, HangsOn allowed) {
  return Reducer(problem, keep, allowed).run();
}

}  // namespace gcs
