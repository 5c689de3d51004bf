#include "solvers/counting/orientation_count.hpp"

#include <algorithm>
#include <map>

namespace gcs {
namespace {

class OrientationCount {
 public:
  OrientationCount(const std::vector<std::array<int, 2>>& edges, const std::vector<int>& outdegrees,
                   std::int64_t& states_left)
      : edges_(edges), start_(outdegrees), states_left_(states_left), degree_(outdegrees.size(), 0) {
    for (const auto& edge : edges)
      for (const int end : edge) ++degree_[end];
  }

  std::optional<Natural> run() {
    if (!is_possible(start_)) return Natural();
    counts_ = {{start_, Natural(1)}};
    for (int vertex = next(); vertex >= 0; vertex = next())
      if (!work_off(vertex)) return std::nullopt;
    return counts_.empty() ? Natural() : counts_.begin()->second;
  }

 private:
  /// Outdegrees that are left, of all vertices.
  using State = std::vector<int>;

  bool is_possible(const State& state, int vertex) const {
    return state[vertex] >= 0 && state[vertex] <= degree_[vertex];
  }

  bool is_possible(const State& state) const {
    for (std::size_t v = 0; v < state.size(); ++v)
      if (!is_possible(state, static_cast<int>(v))) return false;
    return true;
  }

  /// How many other vertices the vertex would leave half worked off that are still untouched.
  int newly_touched(int vertex) const {
    int count = 0;
    for (const auto& [a, b] : edges_)
      if ((a == vertex && !touched_[b]) || (b == vertex && !touched_[a])) ++count;
    return count;
  }

  /// A vertex with edges left that touches fewest new ones, among the touched ones if there are any; −1 when
  /// no edge is left.
  int next() {
    touched_.resize(degree_.size(), false);
    int best = -1;
    const auto cost = [this](int v) { return std::pair{!touched_[v], newly_touched(v)}; };
    for (int v = 0; v < static_cast<int>(degree_.size()); ++v)
      if (degree_[v] > 0 && (best < 0 || cost(v) < cost(best))) best = v;
    return best;
  }

  /// Gives an edge to each of its ends in turn.
  void orient(const std::array<int, 2>& edge) {
    std::map<State, Natural> longer;
    for (const int end : edge) --degree_[end];
    for (const auto& [state, count] : counts_)
      for (const int end : edge) {
        State left = state;
        --left[end];
        if (is_possible(left, edge[0]) && is_possible(left, edge[1])) longer[left] += count;
      }
    counts_ = std::move(longer);
  }

  /// Orients all edges that the vertex has left. False when there are too many states.
  bool work_off(int vertex) {
    std::vector<std::array<int, 2>> others;
    for (const auto& edge : edges_) {
      if (edge[0] != vertex && edge[1] != vertex) {
        others.push_back(edge);
        continue;
      }
      orient(edge);
      for (const int end : edge) touched_[end] = true;
      states_left_ -= static_cast<std::int64_t>(counts_.size());
      if (states_left_ < 0) return false;
    }
    edges_ = std::move(others);
    return true;
  }

  std::vector<std::array<int, 2>> edges_;  ///< not oriented yet
  State start_;
  std::int64_t& states_left_;
  std::vector<int> degree_;  ///< by edges not oriented yet
  std::vector<bool> touched_;
  std::map<State, Natural> counts_;
};

}  // namespace

std::optional<Natural> count_orientations(const std::vector<std::array<int, 2>>& edges,
                                          const std::vector<int>& outdegrees, std::int64_t& states_left) {
  return OrientationCount(edges, outdegrees, states_left).run();
}

}  // namespace gcs
