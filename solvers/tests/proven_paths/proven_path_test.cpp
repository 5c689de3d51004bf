/// Proven paths against an ellipse in closed form, and against the points of an independent tracker:
/// Euler-Newton as published, with steps so small that it keeps to the path.

#include "solvers/proven_paths/proven_path.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/proven_paths/path_jumps.hpp"
#include "solvers/tests/proven_paths/along_polyline.hpp"
#include "solvers/tests/proven_paths/thin_ellipse.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tests/sanitized.hpp"

using namespace gcs;
using namespace gcs::samples;

namespace {

constexpr double newton_distance = 1e-8;

/// Of the ellipse's points in floating point, and of S with the triangle's sides as doubles.
constexpr double rounding = 1e-12;

/// Series so long that the tubes' radii are small beside those of the polylines.
SeriesTrackerOptions sharp() {
  SeriesTrackerOptions options;
  options.tolerance = 1e-12;
  return options;
}

struct BothPaths {
  BothPaths() : scene(samples::octahedron()), certified(scene, {}, {}) {
    certified.keep_arcs();
    proven = certified.run();
    REQUIRE(proven.proven);
    followed = samples::followed_path(scene, 0.02);
  }

  std::vector<PathJump> jumps(const std::vector<Eigen::VectorXd>& points) const {
    return find_jumps(points, certified.arcs(), proven.crossings, newton_distance);
  }

  Scene scene;
  CertifiedTracker certified;
  TrackedPath proven, followed;
};

/// The unit circle's Taylor series about an angle.
ArcSeries about(double angle) {
  constexpr int order = 12;
  ArcSeries series(2, order);
  double factorial = 1;
  for (int n = 0; n <= order; ++n) {
    if (n > 0) factorial *= n;
    series.coefficient(n)[0] = std::cos(angle + n * std::numbers::pi / 2) / factorial;
    series.coefficient(n)[1] = std::sin(angle + n * std::numbers::pi / 2) / factorial;
  }
  return series;
}

/// Tubes of half length h around it, entered at −0.88 h and left at 0.96 h; the last one ends where the first
/// began.
std::vector<ProvenArc> around_circle(double h) {
  constexpr double whole = 2 * std::numbers::pi;
  std::vector<ProvenArc> arcs{{about(0), 0, 0.96 * h, 0, 1e-10, 1, {}}};
  for (double reached = 0.96 * h; reached < whole;) {
    const double middle = reached + 0.88 * h, last = std::min(0.96 * h, whole - middle);
    arcs.push_back({about(middle), -0.88 * h, last, reached, 1e-10, 1, {}});
    reached = middle + last;
  }
  return arcs;
}

}  // namespace

TEST_CASE("every point of a path has its place, however short the last stretch is") {
  for (int i = 0; i < repetitions(25); ++i) {
    const double h = 0.4 + 0.01 * i;
    CAPTURE(h);
    const std::vector<ProvenArc> arcs = around_circle(h);
    PathPlaces places(arcs, 1e-7);
    for (double angle = 0.001; angle < 6.28; angle += 0.001) {
      const auto place = places.find(Eigen::Vector2d(std::cos(angle), std::sin(angle)));
      REQUIRE(place);
      CHECK(*place == Approx(angle).margin(1e-6));
    }
  }
}

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

TEST_CASE("a polyline is as near to a path that is known in closed form as it says, and not much nearer") {
  const Ellipse ellipse;
  CertifiedTracker tracker(ellipse.scene, sharp(), {});
  tracker.keep_arcs();
  REQUIRE(tracker.run().proven);
  std::vector<Eigen::VectorXd> points;
  constexpr int samples = 100'000;
  for (int i = 0; i <= samples; ++i)
    points.push_back(ellipse.point_at(Ellipse::angle_at_start() - 2 * M_PI * i / samples));
  std::size_t fewer = points.size();
  for (const double within : {1e-6, 1e-4, 1e-2}) {
    CAPTURE(within);
    const std::vector<PathNode> nodes = polyline(tracker.arcs(), within);
    for (const PathNode& node : nodes) CHECK(node.radius <= within);
    CHECK(keeps_along(points, nodes, rounding));
    CHECK_FALSE(keeps_along(points, nodes, rounding, 0.5));
    CHECK((nodes.front().point - points.front()).norm() <= rounding);
    CHECK(nodes.back().point == nodes.front().point);
    CHECK(nodes.size() < fewer);
    fewer = nodes.size();
  }
}

TEST_CASE("the crossings of t = 1 are corners of the polyline") {
  const Ellipse ellipse;
  CertifiedTracker tracker(ellipse.scene, sharp(), {});
  tracker.keep_arcs();
  REQUIRE(tracker.run().proven);
  std::vector<PathNode> crossings = polyline(tracker.arcs(), 0.1);
  std::erase_if(crossings, [](const PathNode& node) { return node.crossing == 0; });
  REQUIRE(crossings.size() == 2);
  for (const PathNode& node : crossings) {
    // Towards growing t above the base, and back below it.
    CHECK(node.crossing == (&node == &crossings.front() ? 1 : -1));
    CHECK((node.point - ellipse.point(side_at_target, node.crossing)).norm() <= 1e-9);
  }
}

TEST_CASE("the points of a careful tracker keep to the polyline") {
  const BothPaths paths;
  for (const double within : {1e-5, 1e-3, 1e-1}) {
    const std::vector<PathNode> nodes = polyline(paths.certified.arcs(), within);
    CHECK(keeps_along(paths.followed.points, nodes, newton_distance));
    CHECK(nodes.back().length == Approx(paths.proven.length).epsilon(1e-9));
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
