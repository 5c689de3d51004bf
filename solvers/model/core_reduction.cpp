#include "solvers/model/core_reduction.hpp"

#include <algorithm>

namespace gcs {

namespace {

class Reducer {
 public:
  Reducer(const Problem& problem, const std::vector<int>& keep)
      : problem_(problem), keep_(keep), present_(problem.points.size() + problem.lines.size(), true) {}

  CoreReduction run() {
    for (int point = next(); point >= 0; point = next()) {
      result_.placed.push_back({point, neighbours(point)});
      present_[point] = false;
    }
    std::reverse(result_.placed.begin(), result_.placed.end());
    list_core();
    return result_;
  }

 private:
  bool is_kept(int entity) const { return std::find(keep_.begin(), keep_.end(), entity) != keep_.end(); }

  bool anchored() const {
    for (int entity = 0; entity < static_cast<int>(present_.size()); ++entity)
      if (problem_.is_fixed(entity)) return true;
    return false;
  }

  std::vector<int> neighbours(int entity) const {
    std::vector<int> result;
    for (const DistanceConstraint& constraint : problem_.constraints)
      for (const int side : {0, 1})
        if (constraint.between[side] == entity && present_[constraint.between[1 - side]])
          result.push_back(constraint.between[1 - side]);
    return result;
  }

  std::ptrdiff_t left() const { return std::count(present_.begin(), present_.end(), true); }

  /// Entities that no rigid motion moves are needed to count degrees of freedom as before: d points, or a
  /// line and another entity; fixed positions do the same.
  std::ptrdiff_t smallest_rest() const {
    if (anchored()) return 0;
    return problem_.lines.empty() ? problem_.dimension : 2;
  }

  bool can_go(int point) const {
    return present_[point] && !problem_.is_fixed(point) &&
           static_cast<int>(neighbours(point).size()) == problem_.dimension;
  }

  /// The last point that can go, one that need not be kept if there is one; −1 when none can.
  int next() const {
    if (left() <= smallest_rest()) return -1;
    int kept = -1;
    for (int point = static_cast<int>(problem_.points.size()) - 1; point >= 0; --point) {
      if (!can_go(point)) continue;
      if (!is_kept(point)) return point;
      kept = std::max(kept, point);
    }
    return kept;
  }

  void list_core() {
    bool only_fixed = true;
    for (int entity = 0; entity < static_cast<int>(present_.size()); ++entity) {
      if (!present_[entity]) continue;
      only_fixed = only_fixed && problem_.is_fixed(entity);
      result_.core.push_back(entity);
    }
    result_.core_is_trivial = only_fixed || (!anchored() && left() <= smallest_rest());
    for (int i = 0; i < static_cast<int>(problem_.constraints.size()); ++i) {
      const auto [a, b] = problem_.constraints[i].between;
      if (present_[a] && present_[b]) result_.core_constraints.push_back(i);
    }
  }

  const Problem& problem_;
  const std::vector<int>& keep_;
  std::vector<bool> present_;
  CoreReduction result_;
};

}  // namespace

CoreReduction reduce_to_core(const Problem& problem, const std::vector<int>& keep) {
  return Reducer(problem, keep).run();
}

}  // namespace gcs
