#include "solvers/elements/constraint_types.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "solvers/elements/scene_system.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;

namespace {

/// Five points of which three make the frame, two lines, two planes: everything that a relation may be between.
struct World {
  explicit World(std::uint64_t seed) : random(seed) {
    problem.points = {"o", "a", "b", "c", "d"};
    problem.lines = {"L", "M"};
    problem.planes = {"E", "F"};
    problem.reference = Reference{0, 1, 2};
    figure.points = random.points(3, 5, 2);
    figure.points.col(0).setZero();
    figure.points.col(1).tail<2>().setZero();
    figure.points(2, 2) = 0;
    for (int i = 0; i < 2; ++i) {
      figure.lines.push_back({random.point(3, 2), random.point(3, 1).normalized()});
      figure.planes.push_back({random.point(3, 1).normalized(), random.uniform(-1, 1)});
    }
  }

  Eigen::Vector3d point(int i) const { return figure.points.col(i); }
  const LinePosition& line(int i) const { return figure.lines[static_cast<std::size_t>(i)]; }
  LinePosition& line(int i) { return figure.lines[static_cast<std::size_t>(i)]; }
  PlanePosition& plane(int i) { return figure.planes[static_cast<std::size_t>(i)]; }
  Eigen::Vector3d c_to_d() const { return point(4) - point(3); }
  void put(int i, const Eigen::Vector3d& where) { figure.points.col(i) = where; }

  samples::RandomNumbers random;
  ProblemStatement problem;
  Figure figure;
};

constexpr int line_0 = 5, line_1 = 6, plane_0 = 7, plane_1 = 8;
const Operand point_c{3}, a_line{line_0}, other_line{line_1}, a_plane{plane_0}, other_plane{plane_1},
    c_d{3, 4}, a_b{1, 2};

double degrees(double cosine) { return std::acos(cosine) * 180 / std::numbers::pi; }

/// The value by geometry, of a figure that `prepare` made meet the constraint or something that it presupposes.
struct Sample {
  std::string name;
  Relation relation;
  std::function<void(World&)> prepare = [](World&) {};
  std::function<double(World&)> value = nullptr;  ///< null: the constraint has none
};

double line_distance(const World& w) {
  const Eigen::Vector3d n = w.line(0).direction.cross(w.line(1).direction).normalized();
  return std::abs(n.dot(w.line(0).point - w.line(1).point));
}

std::vector<Sample> samples_of_all_kinds() {
  using F = Relation::Form;
  const auto along = [](World& w, int line, double t) {
    return Eigen::Vector3d(w.line(line).point + t * w.line(line).direction);
  };
  const auto onto = [](World& w, const Eigen::Vector3d& p) {
    return Eigen::Vector3d(p - w.plane(0).normal * (w.plane(0).normal.dot(p) - w.plane(0).offset));
  };
  const auto flat = [](World& w, const Eigen::Vector3d& v) {
    return Eigen::Vector3d(v - w.plane(0).normal * w.plane(0).normal.dot(v)).normalized().eval();
  };
  return {
      {"point line",
       {"r", "distance", {point_c, a_line}, F::length},
       [](World&) {},
       [](World& w) { return (w.point(3) - w.line(0).point).cross(w.line(0).direction).norm(); }},
      {"line line", {"r", "distance", {a_line, other_line}, F::length}, [](World&) {}, line_distance},
      {"line line squared",
       {"r", "distance", {other_line, a_line}, F::squared},
       [](World&) {},
       [](World& w) { return std::pow(line_distance(w), 2); }},
      {"point plane",
       {"r", "distance", {point_c, a_plane}, F::length},
       [](World&) {},
       [](World& w) { return w.plane(0).normal.dot(w.point(3)) - w.plane(0).offset; }},
      {"angle of lines",
       {"r", "angle", {a_line, other_line}, F::degrees},
       [](World&) {},
       [](World& w) { return degrees(std::abs(w.line(0).direction.dot(w.line(1).direction))); }},
      {"angle of line and segment",
       {"r", "angle", {c_d, a_line}, F::cosine},
       [](World&) {},
       [](World& w) { return std::abs(w.c_to_d().normalized().dot(w.line(0).direction)); }},
      {"angle of line and plane",
       {"r", "angle", {a_line, a_plane}, F::degrees},
       [](World&) {},
       [](World& w) { return 90 - degrees(std::abs(w.line(0).direction.dot(w.plane(0).normal))); }},
      {"angle of segment and plane",
       {"r", "angle", {a_plane, c_d}, F::degrees},
       [](World&) {},
       [](World& w) { return 90 - degrees(std::abs(w.c_to_d().normalized().dot(w.plane(0).normal))); }},
      {"angle of planes",
       {"r", "angle", {a_plane, other_plane}, F::degrees},
       [](World&) {},
       [](World& w) { return degrees(w.plane(0).normal.dot(w.plane(1).normal)); }},
      {"angle of segments",
       {"r", "angle", {a_b, c_d}, F::cosine},
       [](World&) {},
       [](World& w) { return w.c_to_d().normalized().dot((w.point(2) - w.point(1)).normalized()); }},
      {"angle of segments the other way",
       {"r", "angle", {a_b, {4, 3}}, F::cosine},
       [](World&) {},
       [](World& w) { return -w.c_to_d().normalized().dot((w.point(2) - w.point(1)).normalized()); }},
      {"point on line", {"r", "on", {point_c, a_line}}, [=](World& w) { w.put(3, along(w, 0, 0.7)); }},
      {"point on plane", {"r", "on", {a_plane, point_c}}, [=](World& w) { w.put(3, onto(w, w.point(3))); }},
      {"line on plane",
       {"r", "on", {a_line, a_plane}},
       [=](World& w) {
         w.line(0) = {onto(w, w.line(0).point), flat(w, w.line(0).direction)};
       }},
      {"meeting lines",
       {"r", "meet", {a_line, other_line}},
       [=](World& w) { w.line(1).point = along(w, 0, -0.4); }},
      {"parallel lines",
       {"r", "parallel", {a_line, other_line}},
       [](World& w) { w.line(1).direction = w.line(0).direction; }},
      {"parallel line and segment",
       {"r", "parallel", {a_line, c_d}},
       [](World& w) { w.put(4, w.point(3) + 1.3 * w.line(0).direction); }},
      {"parallel segments",
       {"r", "parallel", {a_b, c_d}},
       [](World& w) { w.put(4, w.point(3) - 0.6 * (w.point(2) - w.point(1))); }},
      {"parallel line and plane",
       {"r", "parallel", {a_plane, a_line}},
       [=](World& w) { w.line(0).direction = flat(w, w.line(0).direction); }},
      {"parallel segment and plane",
       {"r", "parallel", {c_d, a_plane}},
       [=](World& w) { w.put(4, w.point(3) + flat(w, w.c_to_d())); }},
      {"perpendicular lines",
       {"r", "perpendicular", {a_line, other_line}},
       [](World& w) { w.line(1).direction = w.line(0).direction.unitOrthogonal(); }},
      {"perpendicular line and segment",
       {"r", "perpendicular", {a_line, c_d}},
       [](World& w) { w.put(4, w.point(3) + 2 * w.line(0).direction.unitOrthogonal()); }},
      {"perpendicular segments",
       {"r", "perpendicular", {c_d, a_b}},
       [](World& w) { w.put(4, w.point(3) + (w.point(2) - w.point(1)).unitOrthogonal()); }},
      {"perpendicular planes",
       {"r", "perpendicular", {a_plane, other_plane}},
       [](World& w) { w.plane(1).normal = w.plane(0).normal.unitOrthogonal(); }},
      {"perpendicular line and plane",
       {"r", "perpendicular", {a_line, a_plane}},
       [](World& w) { w.line(0).direction = w.plane(0).normal; }},
      {"perpendicular segment and plane",
       {"r", "perpendicular", {c_d, a_plane}},
       [](World& w) { w.put(4, w.point(3) - 0.8 * w.plane(0).normal); }},
      {"collinear",
       {"r", "collinear", {{1}, {3}, {4}}},
       [](World& w) { w.put(4, w.point(3) + 0.3 * (w.point(3) - w.point(1))); }},
      {"coplanar",
       {"r", "coplanar", {{0}, {1}, {3}, {4}}},
       [](World& w) { w.put(4, 0.3 * w.point(3) - 0.5 * w.point(1)); }},
  };
}

Scene scene_of(const World& world, const Relation& relation) {
  ProblemStatement problem = world.problem;
  problem.relations = {relation};
  return Scene::unchecked(problem);
}

double residual_of(const Scene& scene, const World& world) {
  return relative_residual(scene, world.figure.scaled(-scene.unit_exponent()));
}

}  // namespace

TEST_CASE("the equations of every kind hold where geometry says that the constraint does, and nowhere else") {
  for (const Sample& sample : samples_of_all_kinds()) {
    INFO(sample.name);
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
      World world(seed);
      sample.prepare(world);
      Relation relation = sample.relation;
      if (sample.value) relation.given.value = sample.value(world);
      const Scene scene = scene_of(world, relation);
      REQUIRE_FALSE(why_no_system(scene));
      CHECK(residual_of(scene, world) <= 1e-14);
      if (sample.value) {
        relation.given.value *= 1.01;
        CHECK(residual_of(scene_of(world, relation), world) > 1e-6);
      } else {
        World moved(seed);
        CHECK(residual_of(scene, moved) > 1e-4);
      }
    }
  }
}

TEST_CASE("every kind takes the freedoms that the contract says") {
  const std::map<std::string, int> taken{{"point on line", 2},
                                         {"line on plane", 2},
                                         {"parallel lines", 2},
                                         {"parallel line and segment", 2},
                                         {"parallel segments", 2},
                                         {"perpendicular line and plane", 2},
                                         {"perpendicular segment and plane", 2},
                                         {"collinear", 2}};
  for (const Sample& sample : samples_of_all_kinds()) {
    INFO(sample.name);
    World world(1);
    const Scene with = scene_of(world, sample.relation);
    ProblemStatement free = world.problem;
    const Scene without = Scene::unchecked(free);
    const auto freedom = [](const Scene& scene) {
      const SceneSystem system(scene);
      return system.equations().unknowns - static_cast<int>(system.equations().equations.size());
    };
    const auto found = taken.find(sample.name);
    CHECK(freedom(without) == 9 + 8 + 6);
    CHECK(freedom(without) - freedom(with) == (found == taken.end() ? 1 : found->second));
  }
}

TEST_CASE("a figure comes back from its unknowns") {
  World world(5);
  const Scene scene = scene_of(world, {"r", "angle", {a_line, c_d}, Relation::Form::cosine, {0.5, ""}});
  const SceneSystem system(scene);
  const Figure before = world.figure.scaled(-scene.unit_exponent());
  const Figure after = system.figure(system.coordinates(before), true);
  CHECK((before.points - after.points).norm() <= 1e-14);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(before.lines[i].direction.cross(after.lines[i].direction).norm() <= 1e-14);
    CHECK((after.lines[i].point - before.lines[i].point).cross(before.lines[i].direction).norm() <= 1e-14);
    CHECK(std::abs(after.lines[i].point.dot(after.lines[i].direction)) <= 1e-14);
    const double sign = before.planes[i].normal.dot(after.planes[i].normal);
    CHECK(std::abs(sign) == Approx(1));
    CHECK(std::abs(before.planes[i].offset - sign * after.planes[i].offset) <= 1e-14);
  }
}
