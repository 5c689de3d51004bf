#include "solvers/structure/decomposition.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "solvers/structure/core_reduction.hpp"
#include "solvers/structure/sub_problem.hpp"

namespace gcs {
namespace {

using Points = std::vector<int>;  // ascending

/// Points beside d others that are left to the strategy even where all can be placed one by one: what it
/// makes of them is to be seen, and takes no time.
constexpr int left_to_solve = 2;

/// The graph of the given distances between points.
class DistanceGraph {
 public:
  explicit DistanceGraph(const ProblemStatement& problem)
      : dimension_(problem.dimension), edges_(problem.points.size()) {
    for (int i = 0; i < static_cast<int>(problem.constraints.size()); ++i) {
      const auto& [a, b] = problem.constraints[i].between;
      if (!problem.is_point(a) || !problem.is_point(b)) continue;
      edges_[a].push_back({b, i});
      edges_[b].push_back({a, i});
    }
  }

  /// The constraint between two points, or −1.
  int constraint(int a, int b) const {
    for (const auto& [other, index] : edges_[a])
      if (other == b) return index;
    return -1;
  }

  /// Between all pairs of the points, the first with each other, then the second, …; −1 where there is none.
  std::vector<int> constraints_between(const Points& points) const {
    std::vector<int> found;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = i + 1; j < points.size(); ++j) found.push_back(constraint(points[i], points[j]));
    return found;
  }

  /// All sets of d points of `among` that are pairwise joined.
  std::vector<Points> simplices(const Points& among) const {
    std::vector<Points> found;
    for (const int a : among)
      for (const auto& [b, edge] : edges_[a]) {
        if (b < a || !contains(among, b)) continue;
        if (dimension_ == 2) found.push_back({a, b});
        for (const auto& [c, other] : edges_[b])
          if (dimension_ == 3 && c > b && contains(among, c) && constraint(a, c) >= 0)
            found.push_back({a, b, c});
      }
    return found;
  }

  /// The connected components of `among` without `separator`.
  std::vector<Points> components(const Points& among, const Points& separator) const {
    Points left;
    std::set_difference(among.begin(), among.end(), separator.begin(), separator.end(),
                        std::back_inserter(left));
    std::vector<bool> waits(edges_.size(), false);
    for (const int point : left) waits[point] = true;
    std::vector<Points> result;
    for (const int start : left)
      if (waits[start]) result.push_back(reached_from(start, waits));
    return result;
  }

 private:
  static bool contains(const Points& points, int point) {
    return std::binary_search(points.begin(), points.end(), point);
  }

  /// What hangs together with `start`; no longer waits.
  Points reached_from(int start, std::vector<bool>& waits) const {
    Points reached{start};
    waits[start] = false;
    for (std::size_t next = 0; next < reached.size(); ++next)
      for (const auto& [other, edge] : edges_[reached[next]])
        if (waits[other]) {
          waits[other] = false;
          reached.push_back(other);
        }
    std::sort(reached.begin(), reached.end());
    return reached;
  }

  int dimension_;
  std::vector<std::vector<std::array<int, 2>>> edges_;  ///< of each point: another one, and the constraint
};

Points united(const Points& a, const Points& b) {
  Points result;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

Points common(const Points& a, const Points& b) {
  Points result;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
  return result;
}

/// Appends the pieces, each with the simplices at which it is joined to others, that no simplex separates.
void split_at_simplices(const DistanceGraph& graph, const Points& points, std::vector<Points>& pieces) {
  for (const Points& simplex : graph.simplices(points)) {
    const std::vector<Points> sides = graph.components(points, simplex);
    if (sides.size() < 2) continue;
    for (const Points& side : sides) split_at_simplices(graph, united(side, simplex), pieces);
    return;
  }
  pieces.push_back(points);
}

/// The pieces of a core as parts: each shares d points with those before it.
std::vector<Part> joined(const DistanceGraph& graph, int dimension, std::vector<Points> pieces) {
  std::vector<Part> parts;
  Points placed;
  while (!pieces.empty()) {
    const auto next = std::find_if(pieces.begin(), pieces.end(), [&](const Points& piece) {
      return placed.empty() || static_cast<int>(common(piece, placed).size()) == dimension;
    });
    Part part;
    part.base = common(*next, placed);
    part.base_constraints = graph.constraints_between(part.base);
    std::set_difference(next->begin(), next->end(), part.base.begin(), part.base.end(),
                        std::back_inserter(part.points));
    placed = united(placed, *next);
    parts.push_back(std::move(part));
    pieces.erase(next);
  }
  return parts;
}

Points points_among(const ProblemStatement& problem, const std::vector<int>& entities) {
  Points points;
  for (const int entity : entities)
    if (problem.is_point(entity)) points.push_back(entity);
  return points;
}

/// Of each entity, whether it is a line or one of the points.
std::vector<bool> present(const ProblemStatement& problem, const Part& part) {
  std::vector<bool> is_there(problem.points.size() + problem.lines.size(), false);
  for (const auto* points : {&part.base, &part.points})
    for (const int point : *points) is_there[point] = true;
  for (std::size_t line = problem.points.size(); line < is_there.size(); ++line)
    is_there[line] = part.base.empty();
  return is_there;
}

void list_constraints(const ProblemStatement& problem, const DistanceGraph& graph, Part& part) {
  if (part.is_hung_point()) {
    for (const int point : part.base)
      part.constraints.push_back(graph.constraint(part.points.front(), point));
    return;
  }
  const std::vector<bool> is_there = present(problem, part);
  for (int i = 0; i < static_cast<int>(problem.constraints.size()); ++i) {
    const auto& [a, b] = problem.constraints[i].between;
    if (is_there[a] && is_there[b]) part.constraints.push_back(i);
  }
}

Part hung_point(const DistanceGraph& graph, const PlacedPoint& placed) {
  Part part{placed.from, {}, {placed.point}, {}};
  std::sort(part.base.begin(), part.base.end());
  part.base_constraints = graph.constraints_between(part.base);
  return part;
}

Part whole(const ProblemStatement& problem) {
  Part part;
  for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) part.points.push_back(point);
  for (int i = 0; i < static_cast<int>(problem.constraints.size()); ++i) part.constraints.push_back(i);
  return part;
}

}  // namespace

std::vector<Part> decompose(const ProblemStatement& problem, Split split) {
  if (problem.is_anchored() || problem.is_general()) return {whole(problem)};
  const CoreReduction reduction = reduce_to_core(problem, {}, HangsOn::points);
  const DistanceGraph graph(problem);
  auto hung = reduction.placed.begin();
  Points core = points_among(problem, reduction.core);
  if (problem.lines.empty())
    while (static_cast<int>(core.size()) < problem.dimension + left_to_solve &&
           hung != reduction.placed.end())
      core = united(core, {(hung++)->point});
  std::vector<Points> pieces;
  const bool is_small = static_cast<int>(core.size()) <= problem.dimension + left_to_solve;
  if (split == Split::all && problem.lines.empty() && !is_small)
    split_at_simplices(graph, core, pieces);
  else
    pieces.push_back(core);
  std::vector<Part> parts = joined(graph, problem.dimension, std::move(pieces));
  for (; hung != reduction.placed.end(); ++hung) parts.push_back(hung_point(graph, *hung));
  for (Part& part : parts) list_constraints(problem, graph, part);
  return parts;
}

namespace {

/// The base as a frame of its problem.
Reference frame_of(const std::vector<int>& base, const std::vector<int>& entities) {
  std::array<int, 3> numbers{-1, -1, -1};
  for (std::size_t i = 0; i < base.size(); ++i)
    numbers[i] = static_cast<int>(std::ranges::find(entities, base[i]) - entities.begin());
  return {numbers[0], numbers[1], numbers[2]};
}

}  // namespace

PartProblem part_problem(const ProblemStatement& whole, const Part& part) {
  SubProblem result = sub_problem(whole, present(whole, part));
  if (!part.base.empty()) result.problem.reference = frame_of(part.base, result.entities);
  result.entities.resize(result.problem.points.size());
  return {std::move(result.problem), std::move(result.entities)};
}

}  // namespace gcs
