#include "solvers/structure/length_inequalities.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// A length with a bound on its distance to the exact one. Sums that overflow become infinite, which is no
/// shorter than anything, so that lengths of any size need no scaling.
struct BoundedLength {
  double value = 0;
  double error = 0;

  BoundedLength operator+(const BoundedLength& other) const {
    const double sum = value + other.value;
    return {sum, error + other.error + epsilon * sum};
  }
};

/// From the decimal to the double half a unit in the last place, from its square root at most one more.
BoundedLength given_length(const DistanceConstraint& constraint) {
  const double value = constraint.length();
  return {value, 2 * epsilon * value + std::numeric_limits<double>::denorm_min()};
}

double largest_coordinate(const Eigen::Vector3d& a) { return a.cwiseAbs().maxCoeff(); }

/// Coordinates are decimals that were rounded: the error is relative to them and not to the distance.
BoundedLength distance(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double value = (a - b).stableNorm();
  return {value, 8 * epsilon * (value + largest_coordinate(a) + largest_coordinate(b))};
}

BoundedLength distance(const Eigen::Vector3d& point, const LinePosition& line) {
  const Eigen::Vector3d difference = point - line.point;
  const double value = (difference - difference.dot(line.direction) * line.direction).stableNorm();
  return {value, 16 * epsilon * (value + largest_coordinate(point) + largest_coordinate(line.point))};
}

/// A distance that the file gives between a point and another entity; constraint −1: both are fixed.
struct GivenDistance {
  int point = -1;
  int other = -1;
  int constraint = -1;
  BoundedLength length;
};

/// The shortest ways from one point to all others.
struct Ways {
  std::vector<BoundedLength> length;  ///< infinite: no way
  std::vector<int> previous;
  std::vector<int> constraint;  ///< by which a point is reached
};

class LengthGraph {
 public:
  explicit LengthGraph(const ProblemStatement& problem) : problem_(problem), edges_(problem.points.size()) {
    for (int i = 0; i < static_cast<int>(problem.constraints.size()); ++i) {
      const auto [point, other] =
          std::minmax(problem.constraints[i].between[0], problem.constraints[i].between[1]);
      add({point, other, i, given_length(problem.constraints[i])});
    }
    add_fixed_distances();
  }

  std::vector<ViolatedInequality> violations() const {
    std::vector<ViolatedInequality> result;
    for (int i = 0; i < static_cast<int>(given_.size()); ++i) {
      auto violated = problem_.is_point(given_[i].other) ? check_points(i) : check_line(i);
      if (violated) result.push_back(std::move(*violated));
    }
    return result;
  }

 private:
  void add(const GivenDistance& distance) {
    const int number = static_cast<int>(given_.size());
    given_.push_back(distance);
    if (!problem_.is_point(distance.other)) return;
    edges_[distance.point].push_back(number);
    edges_[distance.other].push_back(number);
  }

  void add_fixed_distances() {
    const int points = static_cast<int>(problem_.points.size());
    const int entities = points + static_cast<int>(problem_.lines.size());
    for (int a = 0; a < points; ++a) {
      if (!problem_.is_fixed(a)) continue;
      const Eigen::Vector3d& position = *problem_.fixed_points[a];
      for (int b = a + 1; b < entities; ++b) {
        if (!problem_.is_fixed(b)) continue;
        add({a, b, -1,
             b < points ? distance(position, *problem_.fixed_points[b])
                        : distance(position, *problem_.fixed_lines[b - points])});
      }
    }
  }

  std::optional<ViolatedInequality> check_points(int number) const {
    const GivenDistance& given = given_[number];
    const Ways ways = shortest_ways(given.point, number);
    return contradiction(given, ways, given.other, ways.length[given.other]);
  }

  std::optional<ViolatedInequality> check_line(int number) const {
    const GivenDistance& given = given_[number];
    const Ways ways = shortest_ways(given.point, number);
    for (const GivenDistance& end : given_) {
      if (end.other != given.other || end.point == given.point) continue;
      auto violated = contradiction(given, ways, end.point, ways.length[end.point] + end.length);
      if (!violated) continue;
      violated->entities.push_back(end.other);
      if (end.constraint >= 0) violated->constraints.push_back(end.constraint);
      return violated;
    }
    return std::nullopt;
  }

  /// Dijkstra's algorithm without one of the given distances.
  Ways shortest_ways(int from, int without) const {
    const double infinity = std::numeric_limits<double>::infinity();
    const std::vector<int> none(edges_.size(), -1);
    Ways ways{std::vector<BoundedLength>(edges_.size(), {infinity, 0}), none, none};
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    ways.length[from] = {0, 0};
    queue.emplace(0, from);
    while (!queue.empty()) {
      const auto [length, point] = queue.top();
      queue.pop();
      if (length > ways.length[point].value) continue;
      for (const int number : edges_[point]) {
        const GivenDistance& edge = given_[number];
        const int to = edge.point == point ? edge.other : edge.point;
        const BoundedLength longer = ways.length[point] + edge.length;
        if (number == without || !(longer.value < ways.length[to].value)) continue;
        ways.length[to] = longer;
        ways.previous[to] = point;
        ways.constraint[to] = edge.constraint;
        queue.emplace(longer.value, to);
      }
    }
    return ways;
  }

  std::optional<ViolatedInequality> contradiction(const GivenDistance& given, const Ways& ways, int end,
                                                  const BoundedLength& other_way) const {
    const BoundedLength& length = given.length;
    if (!(length.value > other_way.value + (length.error + other_way.error))) return std::nullopt;
    ViolatedInequality violated{given.constraint, length.value, other_way.value, {}, {}};
    for (int point = end; point >= 0; point = ways.previous[point]) {
      violated.entities.push_back(point);
      if (ways.constraint[point] >= 0) violated.constraints.push_back(ways.constraint[point]);
    }
    if (given.constraint >= 0) violated.constraints.push_back(given.constraint);
    std::reverse(violated.entities.begin(), violated.entities.end());
    std::reverse(violated.constraints.begin(), violated.constraints.end());
    return violated;
  }

  const ProblemStatement& problem_;
  std::vector<GivenDistance> given_;
  std::vector<std::vector<int>> edges_;  ///< per point: the given distances to other points
};

}  // namespace

std::vector<ViolatedInequality> violated_inequalities(const ProblemStatement& problem) {
  return LengthGraph(problem).violations();
}

}  // namespace gcs
