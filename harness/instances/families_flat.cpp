#include <fmt/format.h>

#include <array>
#include <string>

#include "harness/instances/family_draft.hpp"
#include "harness/instances/family_lists.hpp"

namespace gcs {
namespace {

std::string flat_triangle(const std::string& id, const std::string& epsilon) {
  const std::vector<ExactPoint> points{
      {"0", "0", "0"}, {"2", "0", "0"}, {"1", epsilon, "0"}, {"3", "1", "0"}};
  return text_of(id, measured_at(points, {.dimension = 2,
                                          .points = 4,
                                          .edges = {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}},
                                          .sketch = {{0, 0}, {2, 0}, {0.8, 1}, {2.7, 1.2}}}));
}

Draft tetrahedra(const LongDecimal& height) {
  const std::vector<ExactPoint> points{
      {"0", "0", "0"}, {"2", "0", "0"}, {"0.7", "1.8", "0"}, {"0.9", "0.6", height}, {"2.1", "1.9", "0.8"}};
  return measured_at(points,
                     {.points = 5,
                      .edges = {{0, 1}, {0, 2}, {1, 2}, {0, 3}, {1, 3}, {2, 3}, {1, 4}, {2, 4}, {3, 4}},
                      .sketch = {{0, 0, 0}, {2, 0, 0}, {0.7, 1.8, 0}, {0.9, 0.6, 1}, {2, 1.7, 1}}});
}

std::string flat_tetrahedron(const std::string& id, const std::string& epsilon) {
  return text_of(id, tetrahedra(epsilon));
}

/// The apex of the first tetrahedron is at the height √−ε.
std::string infeasible(const std::string& id, const std::string& epsilon) {
  Draft draft = tetrahedra("0");
  for (const int edge : {3, 4, 5}) {
    LongDecimal& square = draft.squares[static_cast<std::size_t>(edge)];
    square = square - LongDecimal(epsilon);
  }
  return text_of(id, draft);
}

/// Six points on a circle make K3,3 infinitesimally flexible (Bolker, Roth 1980); the last is ε outside.
std::string double_root(const std::string& id, const std::string& epsilon) {
  const LongDecimal out = LongDecimal("5") + LongDecimal(epsilon);
  const std::vector<ExactPoint> points{{"5", "0", "0"},   {"3", "4", "0"},
                                       {"-3", "4", "0"},  {"-5", "0", "0"},
                                       {"-4", "-3", "0"}, {"0", LongDecimal("0") - out, "0"}};
  return text_of(
      id,
      measured_at(points, {.dimension = 2,
                           .points = 6,
                           .edges = {{0, 1}, {0, 3}, {0, 5}, {2, 1}, {2, 3}, {2, 5}, {4, 1}, {4, 3}, {4, 5}},
                           .sketch = {{5, 0.4}, {2.5, 4}, {-3, 3.2}, {-5.2, 0.3}, {-4, -2.5}, {0.6, -5.3}}}));
}

/// Half-way between sketch and target the triangle is flat but for ε: there the path and its mirror image
/// come within about √ε of each other.
std::string near_miss(const std::string& id, const std::string& epsilon) {
  const LongDecimal bend = LongDecimal("4") * (LongDecimal("1.2") - LongDecimal(epsilon));
  return text_of(id,
                 {.dimension = 2,
                  .points = 3,
                  .edges = {{0, 1}, {0, 2}, {1, 2}},
                  .squares = {"1", "1", "1.2"},
                  .sketch = {{0, 0}, {1, 0}, {0.28, 0.96}},
                  .interpolation = fmt::format(R"({{"bent": "a1", "bend": {}}})", bend.text(20))},
                 "length");
}

/// Two sides grow in proportion to t. The third one does as well but for −t²/D, D being the detour: it falls
/// short of the others' difference at about t = D, where the path turns back, the triangle being D times as
/// large.
std::string long_detour(const std::string& id, const std::string& detour) {
  return text_of(id,
                 {.dimension = 2,
                  .points = 3,
                  .edges = {{0, 1}, {0, 2}, {1, 2}},
                  .squares = {"2", "1.9", "2.2"},
                  .sketch = {{0, 0}, {1, 0}, {0.6, 0.8}},
                  .interpolation = fmt::format(R"({{"bent": "a1", "bend": {}}})", 1 / std::stod(detour))},
                 "length");
}

}  // namespace

std::span<const InstanceFamily> flat_families() {
  static const std::array all{
      InstanceFamily{"flat-triangle", "a triangle of height ε: nearly tangent circles", shrinking(),
                     flat_triangle},
      InstanceFamily{"flat-tetrahedron", "a tetrahedron of height ε: nearly tangent spheres", shrinking(),
                     flat_tetrahedron},
      // Half a unit would leave triangles that cannot close.
      InstanceFamily{"infeasible", "a tetrahedron of height √−ε: no real solution", shrinking("0.25"),
                     infeasible},
      InstanceFamily{"double-root", "K3,3 with six points on a circle but for ε", shrinking(), double_root},
      InstanceFamily{"near-miss", "a path that passes its mirror image at about √ε", shrinking(), near_miss},
      InstanceFamily{"long-detour",
                     "a path that goes D times the scene's size away before it comes back",
                     {"1", "1e1", "1e2", "1e3", "1e4", "1e5", "1e6"},
                     long_detour},
  };
  return all;
}

}  // namespace gcs
