#include <array>

#include "harness/instances/family_draft.hpp"
#include "harness/instances/family_lists.hpp"

namespace gcs {
namespace {

std::string tangents(const std::string& id, const std::vector<ExactPoint>& centres,
                     const std::vector<LongDecimal>& squares) {
  return text_of(
      id, {.points = 4, .edges = {{0, 4}, {1, 4}, {2, 4}, {3, 4}}, .squares = squares, .fixed = centres});
}

std::string coplanar_centres(const std::string& id, const std::string& epsilon) {
  return tangents(id, {{"0", "0", "0"}, {"4", "0", "0"}, {"1", "3", "0"}, {"2.5", "1.7", epsilon}},
                  {"1", "1.21", "0.81", "1.44"});
}

std::string collinear_centres(const std::string& id, const std::string& epsilon) {
  const LongDecimal up(epsilon);
  return tangents(id, {{"0", "0", "0"}, {"2", up, "0"}, {"5", "0", up}, {"7", LongDecimal("0") - up, up}},
                  {"1", "1.21", "1.96", "0.81"});
}

std::string touching_spheres(const std::string& id, const std::string& epsilon) {
  const LongDecimal more = LongDecimal("2") + LongDecimal(epsilon);
  return tangents(id, {{"1", "1", "1"}, {"1", "-1", "-1"}, {"-1", "1", "-1"}, {"-1", "-1", "1"}},
                  {more, "2", more, "2"});
}

/// p1, …, p5 as below; their distances to the line are those to their feet on it.
Draft five_points_and_a_line() {
  const std::vector<ExactPoint> points{
      {"-2.5", "-2", "0"}, {"-1", "1.5", "0"}, {"3", "-0.5", "2"}, {"0", "1", "0.5"}, {"0", "0", "1.5"}};
  Draft draft = measured_at(
      points, {.points = 5, .edges = {{0, 4}, {1, 4}, {2, 4}, {3, 4}, {0, 1}, {1, 2}, {3, 0}, {2, 3}}});
  for (int i = 0; i < draft.points; ++i) {
    const ExactPoint& point = points[static_cast<std::size_t>(i)];
    draft.edges.insert(draft.edges.begin() + i, {i, draft.points});
    draft.squares.insert(draft.squares.begin() + i, squared_distance(point, {point[0], "0", "0"}));
  }
  return draft;
}

/// With the line on the x-axis and p5 = (0, 0, h), a point p_i = (x, y, z) that keeps its distances to both
/// moves along w_i = (0, y, z) × (p_i − p5), with some speed t_i. The distances of neighbours in the cycle p1
/// p2 p3 p4 stay when t_i w_i·(p_i − p_j) = t_j w_j·(p_i − p_j). Round the cycle that asks for
///   Π w_i·(p_i − p_j) = Π w_j·(p_i − p_j),
/// which these decimals satisfy exactly. With the side p3–p4 open they move then by a mechanism of which d34
/// has a minimum here; the side is longer than that by ε, in squares, and there are two solutions at about
/// √ε.
std::string open_side(const std::string& id, const std::string& epsilon) {
  Draft draft = five_points_and_a_line();
  draft.squares.back() = draft.squares.back() + LongDecimal(epsilon);
  return text_of(id, draft);
}

}  // namespace

std::span<const InstanceFamily> line_families() {
  static const std::array all{
      InstanceFamily{"coplanar-centres", "tangents of spheres whose centres lie in a plane but for ε",
                     shrinking(), coplanar_centres},
      InstanceFamily{"collinear-centres", "tangents of spheres whose centres lie on a line but for ε",
                     shrinking(), collinear_centres},
      InstanceFamily{"touching-spheres", "tangents of spheres that touch but for ε", shrinking(),
                     touching_spheres},
      InstanceFamily{"open-side", "5p1L with a side longer by ε than a minimum of what the others allow",
                     shrinking(), open_side},
  };
  return all;
}

}  // namespace gcs
