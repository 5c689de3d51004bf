#include "solvers/model/point_reference.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace gcs {
namespace {

/// Of each pair of points that is constrained.
using Lengths = std::map<std::pair<int, int>, double>;

Lengths lengths_of(const ProblemStatement& problem) {
  Lengths lengths;
  for (const DistanceConstraint& c : problem.constraints)
    lengths.emplace(std::minmax(c.between[0], c.between[1]), c.length());
  return lengths;
}

/// To rounding, relative to the shortest: b + c = a.
bool are_in_a_line(std::array<double, 3> sides) {
  constexpr double rounding = 1e-12;
  std::ranges::sort(sides);
  return std::abs(sides[0] - (sides[2] - sides[1])) <= rounding * sides[0];
}

}  // namespace

Reference point_reference(const ProblemStatement& problem) {
  const Lengths lengths = lengths_of(problem);
  const int n = static_cast<int>(problem.points.size());
  const auto length = [&](int a, int b) { return lengths.find(std::minmax(a, b)); };
  Reference in_a_line, loose;
  for (const DistanceConstraint& c : problem.constraints) {
    if (!problem.is_point(c.between[0]) || !problem.is_point(c.between[1])) continue;
    Reference candidate{c.between[0], c.between[1]};
    if (problem.dimension == 2) return candidate;
    for (candidate.plane = 0; candidate.plane < n; ++candidate.plane) {
      if (candidate.plane == candidate.origin || candidate.plane == candidate.axis) continue;
      const auto one = length(candidate.plane, candidate.origin),
                 other = length(candidate.plane, candidate.axis);
      const bool is_triangle = one != lengths.end() && other != lengths.end();
      if (is_triangle && !are_in_a_line({c.length(), one->second, other->second})) return candidate;
      Reference& kept = is_triangle ? in_a_line : loose;
      if (kept.origin < 0) kept = candidate;
    }
  }
  if (in_a_line.origin < 0) return {0, n > 1 ? 1 : -1, problem.dimension == 3 && n > 2 ? 2 : -1};
  return loose.origin < 0 ? in_a_line : loose;
}

}  // namespace gcs
