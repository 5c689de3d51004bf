/// The written polylines against the points of an independent tracker: Euler-Newton as published, with steps
/// so small that it keeps to the path.

#include "harness/results/path_io.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <span>

#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/tests/proven_paths/along_polyline.hpp"
#include "solvers/tests/sanitized.hpp"

using namespace gcs;
using Json = nlohmann::json;

namespace {

/// Of the tracker's points, which correct until a correction is below 1e-10 in the file's unit.
constexpr double newton_distance = 1e-8;

/// What is written of an instance, read again in the scene's unit.
class WrittenPath {
 public:
  explicit WrittenPath(Instance instance)
      : scene(instance.problem), instance_(std::move(instance)), tracker_(scene, sharp(), {}) {
    tracker_.keep_arcs();
    REQUIRE(tracker_.run().proven);
  }

  std::vector<PathNode> corners(double within) const {
    const Json path = Json::parse(path_text(instance_, scene, tracker_.arcs(), within));
    const double unit = path["unit"];
    std::vector<PathNode> nodes;
    for (const Json& row : path["rows"]) {
      const auto numbers = row.get<std::vector<double>>();
      const auto moving = static_cast<Eigen::Index>(numbers.size()) - 3;
      PathNode node{Eigen::VectorXd(moving + 1), numbers[1] / unit, numbers[2] / unit, 0};
      node.point << Eigen::Map<const Eigen::VectorXd>(numbers.data() + 3, moving) / unit, numbers[0];
      nodes.push_back(std::move(node));
    }
    return nodes;
  }

  Scene scene;

 private:
  static SeriesTrackerOptions sharp() {
    SeriesTrackerOptions options;
    options.tolerance = 1e-10;
    return options;
  }

  Instance instance_;
  CertifiedTracker tracker_;
};

constexpr std::string_view triangle = R"({
  "format": "gcsbench-instance/1", "id": "triangle", "dimension": 2, "points": ["a", "b", "c"],
  "constraints": [{"type": "distance", "between": ["a", "b"], "length": 1},
                  {"type": "distance", "between": ["a", "c"], "length": 0.7},
                  {"type": "distance", "between": ["b", "c"], "length": 0.6}],
  "sketch": {"a": [0, 0], "b": [1, 0], "c": [0.5, 0.4]}})";

}  // namespace

TEST_CASE("the points of a careful tracker are within the written radii, and not of half of them") {
  const std::array<std::string, 4> ids{"octahedron", "disulfide", "dodecagon", "k33"};
  for (const std::string& id : std::span(ids).first<repetitions(4)>()) {
    const WrittenPath path(load_instance(id));
    const std::vector<Eigen::VectorXd> points = samples::followed_path(path.scene, 0.01).points;
    for (const double within : {1e-4, 1e-3, 1e-2}) {
      CAPTURE(id, within);
      const std::vector<PathNode> nodes = path.corners(within);
      CHECK(samples::keeps_along(points, nodes, newton_distance));
      CHECK_FALSE(samples::keeps_along(points, nodes, newton_distance, 0.5));
      for (const PathNode& node : nodes) CHECK(node.radius <= within * path.scene.size() * (1 + 1e-12));
    }
  }
}

TEST_CASE("the written radii hold the rounding of the corners") {
  const WrittenPath path(parse_instance(triangle, "triangle.json"));
  const std::vector<Eigen::VectorXd> points = samples::followed_path(path.scene, 1e-3).points;
  // How much of a radius the rounding takes depends on where it lies between two powers of ten.
  for (double within = 1e-3; within < 1e-1; within *= 1.05) {
    CAPTURE(within);
    CHECK(samples::keeps_along(points, path.corners(within), newton_distance));
  }
}
