/// Reduced paths against what the figures themselves say.

#include "harness/drawings/reduced_path.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <map>

#include "harness/drawings/reduced_path_drawing.hpp"
#include "harness/tests/occurrences.hpp"
#include "harness/tests/runs/stored_scenes.hpp"

using namespace gcs;

TEST_CASE("branches of the reduced path end where circles touch") {
  const StoredScene stored = stored_scene(load_instance("k33"));
  const auto reduced = reduced_path(stored);
  REQUIRE(reduced);
  const Scene scene(stored.record.instance.problem);
  REQUIRE(reduced->k.size() == stored.path->corners.size());
  std::map<std::size_t, int> of_instruction;
  for (const BoundaryPlace& place : reduced->boundaries) {
    ++of_instruction[place.instruction];
    const Instruction& instruction = reduced->plan.instructions()[place.instruction];
    const Eigen::Matrix3Xd points = scene.in_scene_unit(place.figure).points;
    const Eigen::Vector3d to_one = center_of(instruction.spheres[0], points) - points.col(instruction.place),
                          to_other =
                              center_of(instruction.spheres[1], points) - points.col(instruction.place);
    CHECK(to_one.cross(to_other).norm() <= 1e-9 * to_one.norm() * to_other.norm());
  }
  CHECK_FALSE(reduced->boundaries.empty());
  // A closed curve comes back to its side.
  for (const auto& [instruction, count] : of_instruction) CHECK(count % 2 == 0);
}

TEST_CASE("the driving parameter is a distance in the figure") {
  // The fixed copy is of p1, the origin, which never moves.
  const StoredScene stored = stored_scene(load_instance("k33"));
  const auto reduced = reduced_path(stored);
  REQUIRE(reduced);
  REQUIRE(reduced->driven_from == 0);
  for (std::size_t i = 0; i < reduced->k.size(); ++i) {
    const Eigen::Matrix3Xd& points = stored.path->corners[i].figure.points;
    CHECK(reduced->k[i] == Approx((points.col(reduced->driven_place) - points.col(0)).norm()));
  }
}

TEST_CASE("only plane scenes with one driving parameter have a reduced path to draw") {
  for (const std::string id : {"octahedron", "dodecagon", "prism", "tangents-durand"})
    CHECK_FALSE(reduced_path(stored_scene(load_instance(id))));
}

TEST_CASE("figures along reduced paths show all points, and what the plan leaves out as arrows") {
  const StoredScene stored = stored_scene(load_instance("k33"));
  const auto reduced = reduced_path(stored);
  const auto drawings = draw_reduced_path(stored);
  REQUIRE(drawings.size() == 4);
  const std::size_t boundaries = std::min<std::size_t>(reduced->boundaries.size(), 6);
  CHECK(occurrences(drawings[1].svg, "class=\"point\"") == 6 * boundaries);
  CHECK(occurrences(drawings[1].svg, "class=\"construction\"") == 2 * boundaries);
  CHECK(occurrences(drawings[1].svg, "class=\"removed\"") == boundaries);
  CHECK(occurrences(drawings[1].svg, "class=\"edge\"") == 8 * boundaries);
  const PlanTrail& trail = stored.record.trails.front();
  std::size_t removed = 0;
  for (std::size_t i = 1; i < trail.places.size() && i <= 6; ++i) removed += trail.places[i].removed.size();
  CHECK(occurrences(drawings[3].svg, "class=\"removed\"") == removed);
}
