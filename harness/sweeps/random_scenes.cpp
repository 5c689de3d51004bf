#include "harness/sweeps/random_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <utility>

#include "solvers/structure/structure.hpp"

namespace gcs {
namespace {

/// The distributions of the standard library differ between implementations; the engine does not.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1), from the 53 leading bits.
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  /// From 0 to count − 1.
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(count)); }

  template <class T>
  void shuffle(std::vector<T>& items) {
    for (int i = static_cast<int>(items.size()); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::mt19937_64 engine_;
};

class HennebergGraph {
 public:
  using Edge = std::array<int, 2>;

  HennebergGraph(const SceneKind& kind, Dice& dice) : dimension_(kind.dimension), dice_(dice) {
    for (; points_ < dimension_; ++points_)
      for (int other = 0; other < points_; ++other) edges_.push_back({other, points_});
    while (points_ < kind.points) grow();
    dice_.shuffle(edges_);
  }

  const std::vector<Edge>& edges() const { return edges_; }

 private:
  /// An edge to split needs d − 1 points that are not its ends.
  void grow() {
    if (points_ > dimension_ && dice_.unit() < 0.75)
      split_edge();
    else
      join_new_point(chosen({}, dimension_));
  }

  void split_edge() {
    const int split = dice_.below(static_cast<int>(edges_.size()));
    const auto [a, b] = edges_[split];
    edges_.erase(edges_.begin() + split);
    std::vector<int> ends = chosen({a, b}, dimension_ - 1);
    ends.insert(ends.end(), {a, b});
    join_new_point(ends);
  }

  void join_new_point(const std::vector<int>& others) {
    for (const int other : others) edges_.push_back({other, points_});
    ++points_;
  }

  /// `count` points other than those excluded, those that hang on d points first.
  std::vector<int> chosen(const std::vector<int>& excluded, int count) {
    std::vector<int> candidates;
    for (int p = 0; p < points_; ++p)
      if (std::find(excluded.begin(), excluded.end(), p) == excluded.end()) candidates.push_back(p);
    dice_.shuffle(candidates);
    std::stable_partition(candidates.begin(), candidates.end(),
                          [this](int p) { return degree(p) <= dimension_; });
    candidates.resize(count);
    return candidates;
  }

  std::ptrdiff_t degree(int point) const {
    return std::count_if(edges_.begin(), edges_.end(),
                         [point](const Edge& edge) { return edge[0] == point || edge[1] == point; });
  }

  int dimension_;
  Dice& dice_;
  int points_ = 0;
  std::vector<Edge> edges_;
};

Figure random_placement(const SceneKind& kind, double size, Dice& dice) {
  Figure figure;
  figure.points = Eigen::Matrix3Xd::Zero(3, kind.points);
  for (int p = 0; p < kind.points; ++p)
    for (int axis = 0; axis < kind.dimension; ++axis) figure.points(axis, p) = size * dice.unit();
  return figure;
}

void add_constraints(const HennebergGraph& graph, ProblemStatement& problem) {
  for (const auto& edge : graph.edges()) {
    DistanceConstraint& constraint = problem.constraints.emplace_back();
    constraint.id = fmt::format("a{}", problem.constraints.size());
    constraint.between = edge;
  }
}

void give_lengths_of(const Figure& figure, ProblemStatement& problem) {
  for (DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = constraint.between;
    constraint.given.value = (figure.points.col(a) - figure.points.col(b)).norm();
    constraint.given.text = fmt::format("{}", constraint.given.value);
  }
}

}  // namespace

SceneKind random_scene_kind(std::uint64_t seed) {
  const int kind = static_cast<int>((seed + scene_kind_count - 1) % scene_kind_count);
  return {2 + kind % 2, 4 + kind / 2};
}

ProblemStatement random_problem(const SceneKind& kind, std::uint64_t seed) {
  Dice dice(seed);
  ProblemStatement problem;
  problem.dimension = kind.dimension;
  for (int p = 1; p <= kind.points; ++p) problem.points.push_back(fmt::format("p{}", p));
  const HennebergGraph graph(kind, dice);
  const double size = std::pow(10.0, 6 * dice.unit() - 3);
  problem.sketch = random_placement(kind, size, dice);
  Figure target = random_placement(kind, size, dice);
  const double way = std::ldexp(1.0, -dice.below(4));
  target.points = way * target.points + (1 - way) * problem.sketch->points;
  add_constraints(graph, problem);
  give_lengths_of(target, problem);
  problem.interpolation.bent = dice.below(static_cast<int>(problem.constraints.size()));
  problem.interpolation.bend = std::ldexp(size, 1 - dice.below(5));
  if (const Structure structure = analyse_structure(problem); !structure.well_posed())
    throw std::logic_error(fmt::format("seed {}: {}", seed, structure.defects.front().what));
  return problem;
}

ProblemStatement random_problem_of_sketch(const SceneKind& kind, std::uint64_t seed) {
  ProblemStatement problem = random_problem(kind, seed);
  give_lengths_of(*problem.sketch, problem);
  return problem;
}

}  // namespace gcs
