/// The proven path of the octahedron against the points of an independent tracker: Euler-Newton as published,
/// with steps so small that it keeps to the path.

#include "solvers/tracking/proven_path.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/tests/sample_problems.hpp"
#include "solvers/tracking/certified_tracker.hpp"
#include "solvers/tracking/euler_newton_tracker.hpp"
#include "solvers/tracking/paper_homotopies.hpp"
#include "solvers/tracking/path_jumps.hpp"

using namespace gcs;

namespace {

constexpr double newton_distance = 1e-8;

struct BothPaths {
  BothPaths() : scene(samples::octahedron()), certified(scene, {}, {}) {
    certified.keep_arcs();
    proven = certified.run();
    REQUIRE(proven.proven);
    PaperDistanceHomotopy homotopy(scene);
    EulerNewtonOptions options;
    options.step_max = 0.02;
    options.keep_points = true;
    followed = EulerNewtonTracker(homotopy, options, {}).run();
    REQUIRE(followed.end == TrackedPath::End::closed);
    for (Eigen::VectorXd& y : followed.points)
      y.head(y.size() - 1) *= std::ldexp(1.0, -scene.unit_exponent());
  }

  std::vector<PathJump> jumps(const std::vector<Eigen::VectorXd>& points) const {
    return find_jumps(points, certified.arcs(), proven.crossings, newton_distance);
  }

  Scene scene;
  CertifiedTracker certified;
  TrackedPath proven, followed;
};

/// Of a point from the segment between two others.
double distance_from_segment(const Eigen::VectorXd& point, const Eigen::VectorXd& a,
                             const Eigen::VectorXd& b) {
  const double along = std::clamp((point - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (point - a - along * (b - a)).norm();
}

}  // namespace

TEST_CASE("the points of a careful tracker lie on the proven path in order") {
  const BothPaths paths;
  PathPlaces places(paths.certified.arcs(), newton_distance);
  double last = 0;
  // The closing point is the start again.
  for (std::size_t i = 1; i + 1 < paths.followed.points.size(); ++i) {
    const auto place = places.find(paths.followed.points[i]);
    REQUIRE(place);
    const double step = (paths.followed.points[i] - paths.followed.points[i - 1]).norm();
    CHECK(*place > last);
    CHECK(*place - last == Approx(step).epsilon(0.01).margin(1e-6));
    last = *place;
  }
  CHECK(paths.proven.length == Approx(last).epsilon(0.01));
  CHECK(paths.jumps(paths.followed.points).empty());
  Eigen::VectorXd beside = paths.followed.points[10];
  beside[0] += 1e-3;
  CHECK_FALSE(places.find(beside));
}

TEST_CASE("the polyline is as near to the path as it says") {
  const BothPaths paths;
  const std::vector<PathNode> nodes = polyline(paths.certified.arcs());
  REQUIRE(nodes.size() == paths.certified.arcs().size() + 1);
  CHECK((nodes.front().point - nodes.back().point).norm() == 0);
  CHECK(nodes.back().length == Approx(paths.proven.length).epsilon(1e-12));
  PathPlaces places(paths.certified.arcs(), newton_distance);
  for (const Eigen::VectorXd& point : paths.followed.points) {
    const auto place = places.find(point);
    REQUIRE(place);
    const auto after =
        std::upper_bound(nodes.begin() + 1, nodes.end() - 1, *place,
                         [](double length, const PathNode& node) { return length < node.length; });
    const PathNode& before = *(after - 1);
    CHECK(distance_from_segment(point, before.point, after->point) <= before.radius + newton_distance);
    CHECK(before.radius <= 0.5);
  }
}

TEST_CASE("a piece that is left out is a jump, and so is a way off the path and back") {
  const BothPaths paths;
  std::vector<Eigen::VectorXd> points = paths.followed.points;
  const auto count = static_cast<std::ptrdiff_t>(points.size());
  points.erase(points.begin() + count / 4, points.begin() + count / 2);
  const std::vector<PathJump> cut = paths.jumps(points);
  REQUIRE(cut.size() == 1);
  CHECK(cut[0].step == count / 4);
  REQUIRE((cut[0].from && cut[0].to));
  const auto crossed = [&](std::ptrdiff_t until) {
    int crossings = 0;
    for (std::ptrdiff_t i = 1; i <= until; ++i) {
      const Eigen::VectorXd &a = paths.followed.points[static_cast<std::size_t>(i - 1)],
                            &b = paths.followed.points[static_cast<std::size_t>(i)];
      crossings += (a[a.size() - 1] < 1) != (b[b.size() - 1] < 1) ? 1 : 0;
    }
    return crossings;
  };
  CHECK(*cut[0].from == crossed(count / 4 - 1));
  CHECK(*cut[0].to == crossed(count / 2));

  points = paths.followed.points;
  for (std::size_t i = 20; i < 30; ++i) points[i][0] += 1e-3;
  const std::vector<PathJump> away = paths.jumps(points);
  REQUIRE(away.size() == 2);
  CHECK(away[0].step == 20);
  CHECK_FALSE(away[0].to);
  CHECK(away[1].step == 30);
  CHECK_FALSE(away[1].from);
  CHECK_THAT(in_words(away), Catch::Contains("jumped 2 times: in step 20") && Catch::Contains("not S"));
}
