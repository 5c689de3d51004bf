#include <array>
#include <string>

#include "harness/instances/family_draft.hpp"
#include "harness/instances/family_lists.hpp"

namespace gcs {
namespace {

/// K3,3 of size 1 with two points that hang on it and are ε away from p1. Each stands at right angles to what
/// it hangs on, so that the condition number stays while the lengths part.
std::string mixed_lengths(const std::string& id, const std::string& epsilon) {
  const LongDecimal small(epsilon);
  const double unit = std::stod(epsilon);
  return text_of(id, measured_at({{"0", "0", "0"},
                                  {"3", "0", "0"},
                                  {"4", "2.5", "0"},
                                  {"2", "3.6", "0"},
                                  {"-1", "2.2", "0"},
                                  {"1.5", "-1.3", "0"},
                                  {"0", small, "0"},
                                  {LongDecimal("0.8") * small, LongDecimal("0.3") * small, "0"}},
                                 {.dimension = 2,
                                  .points = 8,
                                  .edges = {{0, 1},
                                            {0, 3},
                                            {0, 5},
                                            {2, 1},
                                            {2, 3},
                                            {2, 5},
                                            {4, 1},
                                            {4, 3},
                                            {4, 5},
                                            {6, 0},
                                            {6, 1},
                                            {7, 0},
                                            {7, 6}},
                                  .sketch = {{0, 0},
                                             {3.1, 0},
                                             {4.1, 2.4},
                                             {2.1, 3.5},
                                             {-0.9, 2.3},
                                             {1.4, -1.2},
                                             {0, 1.1 * unit},
                                             {0.75 * unit, 0.35 * unit}},
                                  .interpolation = R"({"bent": "a9", "bend": 1})"}));
}

/// p3 and p4 are at heights ε and 2ε over p1 and p2, or below: at most 3ε apart, and p5 is to be 1 from one
/// and 2 from the other. Every triangle can close, and none of the four complex solutions is real; at ε = 0
/// they are at infinity.
std::string inconsistent(const std::string& id, const std::string& epsilon) {
  const LongDecimal low(epsilon), high = LongDecimal("2") * low;
  Draft draft = measured_at({{"0", "0", "0"}, {"2", "0", "0"}, {"1", low, "0"}, {"1", high, "0"}},
                            {.dimension = 2, .points = 4, .edges = {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}}});
  draft.points = 5;
  draft.edges.insert(draft.edges.end(), {{2, 4}, {3, 4}});
  draft.squares.insert(draft.squares.end(), {"1", "4"});
  draft.sketch = {{0, 0}, {2, 0}, {1.1, 0.8}, {0.9, -1.3}, {1.8, 0.3}};
  return text_of(id, draft);
}

// ---- Griffis–Duffy platforms

/// Three points, then the midpoints opposite to them.
std::vector<ExactPoint> with_midpoints(std::vector<ExactPoint> corners) {
  const LongDecimal half("0.5");
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactPoint &a = corners[(i + 1) % 3], &b = corners[(i + 2) % 3];
    corners.push_back({half * (a[0] + b[0]), half * (a[1] + b[1]), half * (a[2] + b[2])});
  }
  return corners;
}

/// Corners of one triangle are joined to midpoints of the other (Griffis, Duffy 1993). Each midpoint is held
/// by the three corners of its own triangle, with which it is coplanar: all their distances are stationary
/// when it leaves the plane, at every solution.
std::string platform(const std::string& id, const std::vector<ExactPoint>& base,
                     const std::vector<ExactPoint>& above) {
  std::vector<ExactPoint> points = with_midpoints(base);
  Draft draft{.points = 12};
  for (const int first : {0, 6}) {
    draft.edges.insert(draft.edges.end(), {{first, first + 1}, {first, first + 2}, {first + 1, first + 2}});
    for (int midpoint = first + 3; midpoint < first + 6; ++midpoint)
      for (int corner = first; corner < first + 3; ++corner) draft.edges.push_back({corner, midpoint});
  }
  for (int i = 0; i < 3; ++i) draft.edges.insert(draft.edges.end(), {{i, 9 + i}, {3 + i, 6 + i}});
  for (const ExactPoint& point : with_midpoints(above)) points.push_back(point);
  for (const ExactPoint& point : points)
    draft.sketch.push_back(
        {std::stod(point[0].text(8)), 0.9 * std::stod(point[1].text(8)), std::stod(point[2].text(8))});
  return text_of(id, measured_at(points, draft));
}

/// Of equal equilateral triangles turned by half a turn the six legs are equal, and the platform moves
/// (Husty, Karger 2000).
std::string griffis_duffy(const std::string& id, const std::string& shape) {
  if (shape == "scalene")
    return platform(id, {{"0", "0", "0"}, {"3", "0.2", "0"}, {"1.1", "2.4", "0"}},
                    {{"2.2", "2.5", "1.7"}, {"-0.4", "1.9", "2.1"}, {"1.3", "-0.8", "1.4"}});
  const LongDecimal root = root_of("3"), minus = LongDecimal("0") - root;
  return platform(id, {{"0", "2", "0"}, {minus, "-1", "0"}, {root, "-1", "0"}},
                  {{"0", "-2", "1.5"}, {root, "1", "1.5"}, {minus, "1", "1.5"}});
}

}  // namespace

std::span<const InstanceFamily> compound_families() {
  static const std::array all{
      InstanceFamily{"mixed-lengths", "K3,3 of size 1 with points at distances ε", shrinking(),
                     mixed_lengths},
      InstanceFamily{"inconsistent", "a point at distances 1 and 2 from points 3ε apart", shrinking_to_zero(),
                     inconsistent},
      InstanceFamily{"griffis-duffy",
                     "a platform with coplanar joints, at which every solution is singular",
                     {"scalene", "equilateral"},
                     griffis_duffy,
                     {"scalene", "equilateral"}},
  };
  return all;
}

}  // namespace gcs
