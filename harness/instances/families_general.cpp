/// Families of lines, planes, angles and bodies. Each scene is measured at a figure that is written down here.

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "harness/instances/family_lists.hpp"
#include "harness/instances/general_draft.hpp"

namespace gcs {
namespace {

LongDecimal minus(const LongDecimal& a) { return LongDecimal("0") - a; }

/// √(1 − a²)
LongDecimal cofunction(const LongDecimal& a) { return root_of(LongDecimal("1") - a * a); }

const NamedPoints& triangle() {
  static const NamedPoints points{
      {"p1", {"0", "0", "0"}}, {"p2", {"2", "0", "0"}}, {"p3", {"0.7", "1.8", "0"}}};
  return points;
}

/// With the distances of all pairs.
GeneralDraft triangle_draft() {
  GeneralDraft draft{.points = names_of(triangle())};
  for (const auto& [a, b] : {std::pair{"p1", "p2"}, {"p1", "p3"}, {"p2", "p3"}})
    draft.constraints.push_back(distance_text(triangle(), a, b));
  return draft;
}

/// L1 through p1 and p2, and L2 through p3.
GeneralDraft two_lines() {
  GeneralDraft draft = triangle_draft();
  draft.lines = {"L1", "L2"};
  for (const auto& [point, line] : {std::pair{"p1", "L1"}, {"p2", "L1"}, {"p3", "L2"}})
    draft.constraints.push_back(relation_text("on", point, line));
  return draft;
}

/// With the sine ε of their angle, L2 is a generator of a narrow cone about a parallel to L1 at the distance 1.8 from it.
/// Two planes through that parallel, mirror images, are 0.6 · 1.8 from L1, with two generators each, some ε apart.
std::string parallel_lines(const std::string& id, const std::string& epsilon) {
  GeneralDraft draft = two_lines();
  draft.constraints.push_back(relation_text("angle", "L1", "L2", "cosine", cofunction(LongDecimal(epsilon))));
  draft.constraints.push_back(relation_text("distance", "L1", "L2", "length", "1.08"));
  return text_of(id, draft);
}

/// The direction u of L2 has u·v = ±ε with that of L1 and a given product with p1 − p3: two pairs of signs, and two mirror
/// images of each.
std::string right_angle(const std::string& id, const std::string& epsilon) {
  GeneralDraft draft = two_lines();
  const LongDecimal cosine(epsilon), sine = cofunction(cosine);
  const ExactPoint u{cosine, LongDecimal("0.6") * sine, LongDecimal("0.8") * sine};
  const ExactPoint arm = cross(difference(place_of(triangle(), "p1"), place_of(triangle(), "p3")), u);
  draft.constraints.push_back(relation_text("angle", "L1", "L2", "cosine", cosine));
  draft.constraints.push_back(relation_text("distance", "p1", "L2", "squared", dot(arm, arm)));
  return text_of(id, draft);
}

/// A through p1 and p2, at a given side of p3: two mirror images. B with a given angle to A and signed distances from p1
/// and p2: two.
std::string two_planes(const std::string& id, const LongDecimal& cosine, const LongDecimal& sine) {
  GeneralDraft draft = triangle_draft();
  draft.planes = {"A", "B"};
  const ExactPoint normal{"0", "0.8", "0.6"}, along{"1", "0", "0"}, up = cross(normal, along);
  ExactPoint tilted{"0", "0", "0"};
  for (std::size_t axis = 0; axis < 3; ++axis)
    tilted[axis] =
        cosine * normal[axis] + sine * (LongDecimal("0.6") * along[axis] + LongDecimal("0.8") * up[axis]);
  const auto height = [](const char* point, const ExactPoint& direction) {
    return dot(direction, place_of(triangle(), point));
  };
  for (const char* point : {"p1", "p2"}) draft.constraints.push_back(relation_text("on", point, "A"));
  draft.constraints.push_back(relation_text("distance", "p3", "A", "length", height("p3", normal)));
  for (const char* point : {"p1", "p2"})
    draft.constraints.push_back(
        relation_text("distance", point, "B", "length", LongDecimal("0.9") + height(point, tilted)));
  draft.constraints.push_back(relation_text("angle", "A", "B", "cosine", cosine));
  return text_of(id, draft);
}

std::string parallel_planes(const std::string& id, const std::string& epsilon) {
  const LongDecimal sine(epsilon);
  return two_planes(id, cofunction(sine), sine);
}

std::string opposite_planes(const std::string& id, const std::string& epsilon) {
  const LongDecimal sine(epsilon);
  return two_planes(id, minus(cofunction(sine)), sine);
}

/// Two bars with a nearly straight angle, and a point on either side of their ends.
std::string straight_segments(const std::string& id, const std::string& epsilon) {
  const LongDecimal sine(epsilon), cosine = cofunction(sine), length("1.5");
  const NamedPoints points{{"p1", {"0", "0", "0"}},
                           {"p2", {"2", "0", "0"}},
                           {"p3", {LongDecimal("2") + length * cosine, length * sine, "0"}},
                           {"p4", {"1.2", "-1.7", "0"}}};
  GeneralDraft draft{.dimension = 2, .points = names_of(points)};
  draft.constraints = {relation_text("distance", "p1", "p2", "length", "2"),
                       relation_text("distance", "p2", "p3", "length", length),
                       distance_text(points, "p1", "p4"), distance_text(points, "p3", "p4"),
                       relation_text("angle", R"(["p2", "p1"])", R"(["p2", "p3"])", "cosine", minus(cosine))};
  return text_of(id, draft);
}

/// A pyramid whose base is at heights of about ε over a plane: an octahedral scene with a plane.
std::string near_plane(const std::string& id, const std::string& epsilon) {
  const LongDecimal unit(epsilon);
  const NamedPoints points{{"p1", {"0", "0", LongDecimal("0.7") * unit}},
                           {"p2", {"3", "0.4", LongDecimal("-0.4") * unit}},
                           {"p3", {"2.6", "2.2", LongDecimal("0.9") * unit}},
                           {"p4", {"-0.3", "1.9", LongDecimal("-0.6") * unit}},
                           {"p5", {"1.1", "0.8", "1.7"}}};
  GeneralDraft draft{.points = names_of(points), .planes = {"A"}};
  for (const auto& [a, b] : {std::pair{"p1", "p2"},
                             {"p2", "p3"},
                             {"p3", "p4"},
                             {"p4", "p1"},
                             {"p1", "p5"},
                             {"p2", "p5"},
                             {"p3", "p5"},
                             {"p4", "p5"}})
    draft.constraints.push_back(distance_text(points, a, b));
  for (const char* point : {"p1", "p2", "p3", "p4"})
    draft.constraints.push_back(relation_text("distance", point, "A", "length", place_of(points, point)[2]));
  return text_of(id, draft);
}

struct Leg {
  const char* base;
  const char* platform;
};

/// Two bodies with legs as long as they are where `placed` says that the platform's points are.
GeneralDraft platform_draft(int dimension, const NamedPoints& base, const NamedPoints& platform,
                            const NamedPoints& placed, const std::vector<Leg>& legs) {
  GeneralDraft draft{.dimension = dimension};
  draft.bodies = {body_text("base", base, dimension), body_text("platform", platform, dimension)};
  for (const auto& [a, b] : legs)
    draft.constraints.push_back(
        relation_text("distance", a, b, "squared", squared_distance(place_of(base, a), place_of(placed, b))));
  return draft;
}

/// A planar platform with six postures up to motion (Hunt 1983), whose bodies have their points on a line but for ε: there
/// mirror images are one, and three are left up to reflection.
std::string straight_bodies(const std::string& id, const std::string& epsilon) {
  const LongDecimal up(epsilon), down = LongDecimal("-0.8") * up;
  const NamedPoints base{{"a1", {"0", "0", "0"}}, {"a2", {"1.7", "0", "0"}}, {"a3", {"3.1", up, "0"}}};
  const NamedPoints platform{{"b1", {"0", "0", "0"}}, {"b2", {"1.2", "0", "0"}}, {"b3", {"2.3", down, "0"}}};
  NamedPoints placed = platform;
  const LongDecimal cosine("0.8"), sine("0.6");
  for (NamedPoint& point : placed) {
    const ExactPoint at = point.at;
    point.at = {LongDecimal("0.6") + cosine * at[0] - sine * at[1],
                LongDecimal("1.4") + sine * at[0] + cosine * at[1], "0"};
  }
  return text_of(id, platform_draft(2, base, platform, placed, {{"a1", "b1"}, {"a2", "b2"}, {"a3", "b3"}}));
}

/// Six points of the base, two legs to each point of a triangle: sixteen postures up to motion, as of octahedra, and eight
/// up to reflection where the base is flat.
std::string flat_base(const std::string& id, const std::string& epsilon) {
  const LongDecimal unit(epsilon);
  const NamedPoints base{{"a1", {"2", "0", "0"}},
                         {"a2", {"1.3", "1.6", unit}},
                         {"a3", {"-1.1", "1.5", LongDecimal("-0.7") * unit}},
                         {"a4", {"-2.1", "0.2", "0"}},
                         {"a5", {"-0.8", "-1.9", LongDecimal("0.6") * unit}},
                         {"a6", {"1.2", "-1.7", "0"}}};
  const NamedPoints platform{
      {"b1", {"1.1", "0", "0"}}, {"b2", {"-0.6", "0.9", "0"}}, {"b3", {"-0.5", "-1.1", "0"}}};
  NamedPoints placed = platform;
  for (NamedPoint& point : placed) {
    const LongDecimal x = point.at[0], y = point.at[1];
    point.at = {LongDecimal("0.2") + LongDecimal("0.6") * x - LongDecimal("0.64") * y,
                LongDecimal("-0.3") + LongDecimal("0.8") * x + LongDecimal("0.48") * y,
                LongDecimal("1.8") + LongDecimal("0.6") * y};
  }
  return text_of(
      id,
      platform_draft(3, base, platform, placed,
                     {{"a1", "b1"}, {"a2", "b1"}, {"a3", "b2"}, {"a4", "b2"}, {"a5", "b3"}, {"a6", "b3"}}));
}

/// An equilateral triangle on three equal legs over its like, but for ε: where it is none it is carried round in a circle.
/// Two of the six postures go to infinity with it, as 1/ε.
std::string symmetric_body(const std::string& id, const std::string& epsilon) {
  const LongDecimal off(epsilon), height = root_of("3");
  const NamedPoints base{{"a1", {"0", "0", "0"}}, {"a2", {"2", "0", "0"}}, {"a3", {"1", height, "0"}}};
  const NamedPoints platform{{"b1", {"0", "0", "0"}},
                             {"b2", {"2", "0", "0"}},
                             {"b3", {LongDecimal("1") + off, height - LongDecimal("0.5") * off, "0"}}};
  GeneralDraft draft = platform_draft(2, base, platform, platform, {});
  for (const auto& [a, b] : {std::pair{"a1", "b1"}, {"a2", "b2"}, {"a3", "b3"}})
    draft.constraints.push_back(relation_text("distance", a, b, "length", "1"));
  return text_of(id, draft);
}

/// A point on a sphere, a plane and a cylinder of a body, in four places; and a plane with a given angle and two signed
/// distances, at two for each. All in units of 2^k.
std::string scaled_body(const std::string& id, const std::string& exponent) {
  const LongDecimal unit(std::ldexp(1.0, std::stoi(exponent)));
  const auto scaled = [&](const char* number) { return unit * LongDecimal(number); };
  const auto point = [&](const char* x, const char* y, const char* z) {
    return coordinates_text({scaled(x), scaled(y), scaled(z)}, 3);
  };
  GeneralDraft draft{.points = {"p"}, .planes = {"B"}};
  draft.bodies = {fmt::format(
      R"("base": {{"a1": {}, "a2": {}, "a3": {}, "A": {{"normal": [0.6, 0, 0.8], "offset": {}}}, "M": {{"point": {}, "direction": [0, 1, 0.5]}}}})",
      point("0", "0", "0"), point("2.1", "0", "0"), point("0.4", "1.7", "0.6"), scaled("-0.5").text(30),
      point("0.3", "0.2", "-0.4"))};
  const auto distance = [&](const char* a, const char* b, const char* length) {
    draft.constraints.push_back(relation_text("distance", a, b, "length", scaled(length)));
  };
  distance("p", "a1", "1.9");
  distance("p", "A", "1.1");
  distance("p", "M", "1.3");
  distance("a2", "B", "0.9");
  distance("p", "B", "-0.5");
  draft.constraints.push_back(relation_text("angle", "B", "A", "cosine", "0.7"));
  return text_of(id, draft);
}

/// Below, doubles hold two solutions for one that is double.
std::vector<std::string> small_angles() { return {"0.5", "1e-1", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10"}; }

}  // namespace

std::span<const InstanceFamily> general_families() {
  static const std::array all{
      InstanceFamily{
          "parallel-lines", "two lines with an angle whose sine is ε", small_angles(), parallel_lines, {}, 2},
      InstanceFamily{"parallel-planes",
                     "two planes with an angle whose sine is ε",
                     small_angles(),
                     parallel_planes,
                     {},
                     2},
      InstanceFamily{"opposite-planes",
                     "two planes whose normals are opposite but for ε",
                     small_angles(),
                     opposite_planes,
                     {},
                     2},
      InstanceFamily{
          "right-angle", "two lines with an angle whose cosine is ε", shrinking(), right_angle, {}, 2},
      InstanceFamily{"straight-segments",
                     "two bars in the plane, stretched out but for ε",
                     small_angles(),
                     straight_segments,
                     {},
                     2},
      InstanceFamily{"near-plane",
                     "a pyramid with its base at distances of ε from a plane",
                     shrinking(),
                     near_plane,
                     {},
                     8},
      InstanceFamily{"straight-bodies",
                     "a planar platform whose joints lie on lines but for ε",
                     shrinking_to_zero(),
                     straight_bodies,
                     {},
                     6,
                     3},
      InstanceFamily{
          "flat-base", "a platform whose base is flat but for ε", shrinking_to_zero(), flat_base, {}, 16, 8},
      InstanceFamily{"symmetric-body",
                     "a planar platform that moves, but for ε",
                     {"0.5", "1e-1", "1e-2", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12", "0"},
                     symmetric_body,
                     {"0"},
                     6},
      InstanceFamily{"scaled-body",
                     "a point and a plane at a body, times 2^k",
                     {"0", "100", "-100", "500", "-500", "1000", "-1000"},
                     scaled_body,
                     {},
                     8},
  };
  return all;
}

}  // namespace gcs
