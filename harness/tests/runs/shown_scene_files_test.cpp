/// Stored scenes against the instance: lengths on the way, at the solutions, and where plans change.

#include "harness/runs/shown_scene_files.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "harness/report/page.hpp"
#include "harness/report/page_scene.hpp"
#include "harness/tests/runs/stored_scenes.hpp"
#include "solvers/figures/congruence.hpp"

using namespace gcs;

namespace {

double distance(const Figure& figure, const DistanceConstraint& c) {
  return (figure.points.col(c.between[0]) - figure.points.col(c.between[1])).norm();
}

/// a(t) of constraint `i` as theory states it: linear, the bent one less bend·t² and more bend·t.
double length_at(const ProblemStatement& problem, std::size_t i, double t) {
  const DistanceConstraint& c = problem.constraints[i];
  const int last = static_cast<int>(problem.constraints.size()) - 1;
  const int bent = problem.interpolation.bent < 0 ? last : problem.interpolation.bent;
  const double bend = static_cast<int>(i) == bent ? problem.interpolation.bend : 0;
  const double sketched = distance(*problem.sketch, c);
  return -bend * t * t + (c.length() - sketched + bend) * t + sketched;
}

constexpr std::string_view chain = R"({
  "format": "gcsbench-instance/1", "id": "chain", "dimension": 2, "points": ["a", "b", "c"],
  "constraints": [{"type": "distance", "between": ["a", "b"], "length": 1},
                  {"type": "distance", "between": ["a", "c"], "length": 0.7},
                  {"type": "distance", "between": ["b", "c"], "length": 0.6}]})";

/// Two regular triangles with corresponding corners at distance 1: the second one goes round on a parallelogram's crank.
constexpr std::string_view prism = R"({
  "format": "gcsbench-instance/1", "id": "prism", "dimension": 2, "points": ["a", "b", "c", "d", "e", "f"],
  "constraints": [{"type": "distance", "between": ["a", "b"], "length": 1},
                  {"type": "distance", "between": ["b", "c"], "length": 1},
                  {"type": "distance", "between": ["c", "a"], "length": 1},
                  {"type": "distance", "between": ["d", "e"], "length": 1},
                  {"type": "distance", "between": ["e", "f"], "length": 1},
                  {"type": "distance", "between": ["f", "d"], "length": 1},
                  {"type": "distance", "between": ["a", "d"], "length": 1},
                  {"type": "distance", "between": ["b", "e"], "length": 1},
                  {"type": "distance", "between": ["c", "f"], "length": 1}]})";

/// What make_scene makes of the instance in a run with that cell, stored and read again.
StoredScene scene_with_cell(const Instance& instance, const std::string& strategy, RunStatus status) {
  RunFile run;
  CellRecord& cell = run.cells.emplace_back();
  cell.spec = {instance.id, strategy, {}};
  cell.status = status;
  SilentMonitor monitor;
  const TestFolder folder;
  store_scene(make_scene(instance, Scene(instance.problem), run, monitor), folder / "");
  return *load_scene(folder / "", instance.id);
}

/// The largest error of a distance but that of constraint `left_out`.
double largest_error(const ProblemStatement& problem, const Figure& figure, const std::string& left_out) {
  double error = 0;
  for (const DistanceConstraint& c : problem.constraints)
    if (c.id != left_out) error = std::max(error, std::abs(distance(figure, c) - c.length()));
  return error;
}

}  // namespace

TEST_CASE("stored paths have the interpolated lengths, and the given ones at crossings") {
  for (const std::string id : {"k33", "octahedron", "disulfide", "dodecagon"}) {
    CAPTURE(id);
    const Instance instance = load_instance(id);
    const StoredScene scene = stored_scene(instance);
    const ProblemStatement& problem = instance.problem;
    REQUIRE(scene.path);
    const double tolerance =
        4 * scene.path->within * Scene(problem).size() * std::ldexp(1.0, Scene(problem).unit_exponent());
    for (const PathCorner& corner : scene.path->corners)
      for (std::size_t i = 0; i < problem.constraints.size(); ++i)
        CHECK(std::abs(distance(corner.figure, problem.constraints[i]) - length_at(problem, i, corner.t)) <=
              tolerance);
    REQUIRE(scene.path->crossings.size() == scene.record.crossings.size());
    for (std::size_t k = 0; k < scene.path->crossings.size(); ++k) {
      const PathCorner& corner = scene.path->corners[scene.path->crossings[k].corner];
      CHECK(corner.t == Approx(1).margin(tolerance));
      CHECK(scene.record.crossings[k]);
      for (const DistanceConstraint& c : problem.constraints)
        CHECK(distance(corner.figure, c) == Approx(c.length()).epsilon(1e-12));
    }
    std::set<int> met;
    for (const auto& crossing : scene.record.crossings) met.insert(crossing->solution);
    const std::map<std::string, std::size_t> on_path{
        {"k33", 2}, {"octahedron", 4}, {"disulfide", 8}, {"dodecagon", 2}};
    CHECK(met.size() == on_path.at(id));
  }
}

TEST_CASE("a scene without a path takes the place of one with") {
  const Instance instance = load_instance("k33");
  SilentMonitor monitor;
  const TestFolder folder;
  MadeScene made = make_scene(instance, Scene(instance.problem), run_with_plans("k33"), monitor);
  store_scene(made, folder / "");
  CHECK(load_scene(folder / "", "k33")->path);
  made.path.reset();
  made.record.crossings.clear();
  made.record.trails.clear();
  store_scene(made, folder / "");
  CHECK_FALSE(load_scene(folder / "", "k33")->path);
}

TEST_CASE("trails go along the path, at its values of t") {
  for (const std::string id : {"k33", "octahedron", "disulfide"}) {
    CAPTURE(id);
    const StoredScene scene = stored_scene(load_instance(id));
    REQUIRE(scene.record.trails.size() == 1);
    const PlanTrail& trail = scene.record.trails.front();
    CAPTURE(trail.cause);
    REQUIRE(trail.places.size() > 1);
    CHECK(trail.places.front().t == 0);
    const auto& corners = scene.path->corners;
    for (std::size_t i = 0; i < trail.places.size(); ++i) {
      const PlanPlace& place = trail.places[i];
      CHECK_FALSE(place.removed.empty());
      if (i > 0) CHECK(place.length > trail.places[i - 1].length);
      const auto after = std::find_if(corners.begin() + 1, corners.end(), [&](const PathCorner& corner) {
        return corner.length >= place.length;
      });
      REQUIRE(after != corners.end());
      const double part = (place.length - (after - 1)->length) / (after->length - (after - 1)->length);
      const double t = (1 - part) * (after - 1)->t + part * after->t;
      CHECK(t == Approx(place.t).margin(5e-3));
    }
  }
}

TEST_CASE("a plan that is changed at the sketch stands before its successor, and none past the end") {
  const StoredScene scene = stored_scene(load_instance("dodecagon"));
  REQUIRE(scene.record.trails.size() == 1);
  const auto& places = scene.record.trails.front().places;
  REQUIRE(places.size() == 2);
  for (const PlanPlace& place : places) CHECK(place.length == Approx(0).margin(1e-4));
  CHECK(places[0].removed != places[1].removed);
}

TEST_CASE("scenes without a path say why, and list their real solutions") {
  const StoredScene lines = stored_scene(load_instance("tangents-fourfold"));
  CHECK_FALSE(lines.path);
  CHECK(lines.record.no_path.find("points with distances") != std::string::npos);
  CHECK(lines.record.are_proven);
  REQUIRE(lines.record.solutions.size() == 3);
  for (const ShownSolution& solution : lines.record.solutions) CHECK(solution.multiplicity == 4);

  const StoredScene found = stored_scene(parse_instance(chain, "chain.json"));
  CHECK(found.record.no_path.find("sketch") != std::string::npos);
  CHECK(found.record.are_proven);
  CHECK(found.record.solutions.size() == 1);
}

TEST_CASE("solutions of general scenes are certified, and their number proven where a bound is met") {
  const StoredScene platform = stored_scene(load_instance("planar-platform"));
  CHECK(platform.record.are_proven);
  CHECK(platform.record.is_real_proven);
  CHECK_FALSE(platform.path);
  const StoredScene planes = stored_scene(load_instance("octahedral-4p2h"));
  CHECK(planes.record.are_proven);
  CHECK(planes.record.has_all_real);
  CHECK(planes.record.is_real_proven);
}

TEST_CASE("a motion that a cell found is stored, all the way round") {
  const Instance instance = parse_instance(std::string(prism), "prism.json");
  const StoredScene scene = scene_with_cell(instance, "monodromy", RunStatus::infinite);
  REQUIRE_FALSE(scene.record.curves.empty());
  for (const ShownCurve& curve : scene.record.curves) {
    CHECK(curve.constraint.empty());
    CHECK_FALSE(curve.from);
    CHECK(curve.label.find("closed") != std::string::npos);
    REQUIRE(curve.figures.size() > 20);
    for (const Figure& figure : curve.figures) CHECK(largest_error(instance.problem, figure, "") < 1e-4);
    CHECK((curve.figures.front().points - curve.figures.back().points).norm() < 1e-4);
  }
  CHECK(scene_with_cell(instance, "monodromy", RunStatus::complete).record.curves.empty());
}

TEST_CASE("the graph that explore walks is stored with figures that meet every value but one") {
  const Instance instance = load_instance("disulfide");
  const ProblemStatement& problem = instance.problem;
  const StoredScene scene = scene_with_cell(instance, "explore", RunStatus::complete);
  const double size = std::ldexp(Scene(problem).size(), Scene(problem).unit_exponent());
  // Distances alone hold it: of each value each solution is on one closed curve, and has a next one.
  REQUIRE(scene.record.curves.size() == scene.record.solutions.size() * problem.constraints.size());
  for (const ShownCurve& curve : scene.record.curves) {
    REQUIRE((curve.from && curve.to));
    const auto solution = [&](const std::optional<int>& number) -> const Figure& {
      return scene.record.solutions[static_cast<std::size_t>(*number)].figure;
    };
    CHECK((curve.figures.front().points - solution(curve.from).points).norm() < 1e-4 * size);
    CHECK(may_be_congruent(complex_points(curve.figures.back()), complex_points(solution(curve.to)),
                           1e-4 * size));
    for (const Figure& figure : curve.figures)
      CHECK(largest_error(problem, figure, curve.constraint) < 1e-4 * size);
  }
  const std::string text = to_json_text(scene.record);
  CHECK(to_json_text(parse_shown_scene(text, "scene.json")) == text);
}

TEST_CASE("of a scene that is too large to draw only the instance is stored") {
  const StoredScene large = stored_scene(load_instance("octahedron-hung@100"));
  CHECK(large.record.solutions.empty());
  CHECK_FALSE(large.path);
  CHECK(large.record.no_path.find("entities") != std::string::npos);
  CHECK(draw_scene(large).empty());
}

TEST_CASE("a stored scene is written as it was read") {
  for (const std::string id : {"k33", "hoffmann-yuan", "octahedral-3p3h"}) {
    const StoredScene scene = stored_scene(load_instance(id));
    REQUIRE_FALSE(scene.record.solutions.empty());
    CHECK(scene.record.solutions.front().figure.planes.size() == scene.record.instance.problem.planes.size());
    const std::string text = to_json_text(scene.record);
    CHECK(to_json_text(parse_shown_scene(text, "scene.json")) == text);
  }
}

TEST_CASE("of a family the first member in the run is drawn") {
  RunFile run;
  for (const std::string id :
       {"octahedron", "flat-triangle@1e-4", "flat-triangle@1e-8", "somebodys@1", "somebodys@2"})
    run.instances.push_back({id, "", "", 1, 2});
  CHECK(is_drawn(run, "octahedron"));
  CHECK(is_drawn(run, "flat-triangle@1e-4"));
  CHECK_FALSE(is_drawn(run, "flat-triangle@1e-8"));
  CHECK(is_drawn(run, "somebodys@2"));
}
