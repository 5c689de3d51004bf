/// Tubes around a path that is known in closed form.

#include "solvers/proven_paths/path_tube.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/proven_paths/start_images.hpp"
#include "solvers/proven_paths/tube_crossings.hpp"
#include "solvers/tests/proven_paths/thin_ellipse.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using namespace gcs::samples;
using Kind = PlaceInTube::Kind;

namespace {

/// From the middle of the tube's proof to its ends.
double largest_proven(PathTube& tube, const Eigen::ArrayXd& room) {
  for (double h = 1; h > 1e-9; h *= 0.8)
    if (tube.prove(h, room)) return h;
  return 0;
}

}  // namespace

TEST_CASE("a tube holds the arc of the ellipse that it is around, and not the one beside it") {
  const Ellipse ellipse;
  PathTube tube = ellipse.tube();
  REQUIRE(tube.expand(ellipse.series(0.55)));
  const double h = largest_proven(tube, 2 * tube.room_for(ellipse.box(0.55, 1), Ellipse::no_spread()));
  CHECK(h > 1e-3);
  int inside = 0;
  for (double side = 0.4; side < 0.7; side += 0.001) {
    const PlaceInTube above = tube.locate(ellipse.box(side, 1), Ellipse::no_spread()),
                      below = tube.locate(ellipse.box(side, -1), Ellipse::no_spread());
    const bool ahead = std::abs((ellipse.point(side, 1) - ellipse.point(0.55, 1)).norm()) > 1.1 * h;
    CAPTURE(side, h);
    CHECK(below.kind == Kind::outside);
    CHECK(above.kind == (ahead ? Kind::outside : above.kind));
    if (above.kind != Kind::inside) continue;
    ++inside;
    CHECK(std::abs(above.s.low) <= h);
    if (std::abs(side - 0.55) > 1e-9) CHECK((above.s.low > 0) == (side > 0.55));
  }
  CHECK(inside > 0);
}

TEST_CASE("an enclosed point of the arc is one of the ellipse") {
  const Ellipse ellipse;
  PathTube tube = ellipse.tube();
  RandomNumbers random(1);
  for (const double side : {0.3, 0.45, 0.55, 0.72}) {
    REQUIRE(tube.expand(ellipse.series(side)));
    const double h = largest_proven(tube, ellipse.no_room());
    REQUIRE(h > 0);
    for (int i = 0; i < 20; ++i) {
      const ArcPoint found = tube.at(random.uniform(-h, h));
      const double t = found.point.mid[3];
      const Eigen::VectorXd radius = found.hull().radius;
      const Eigen::VectorXd exact = ellipse.point(side_at_start + t * (side_at_target - side_at_start), 1);
      // At the same t; the ellipse is known to 1e-13 here.
      const Eigen::VectorXd slope = found.tangent.mid / found.tangent.mid[3];
      const Eigen::VectorXd error =
          radius + radius[3] * slope.cwiseAbs() + Eigen::VectorXd::Constant(4, 1e-13);
      CHECK(((exact - found.point.mid).cwiseAbs() - error).maxCoeff() <= 0);
      CHECK(radius.maxCoeff() <= 1e-10);
      const Eigen::VectorXd exact_slope =
          (ellipse.point(side_at_start + (t + 1e-6) * (side_at_target - side_at_start), 1) -
           ellipse.point(side_at_start + (t - 1e-6) * (side_at_target - side_at_start), 1)) /
          2e-6;
      CHECK((exact_slope - slope).norm() <= 1e-5 * slope.norm() + found.tangent.radius.norm());
    }
  }
}

TEST_CASE("no tube is wide enough for both arcs, however short") {
  const Ellipse ellipse;
  PathTube tube = ellipse.tube();
  REQUIRE(tube.expand(ellipse.series(0.55)));
  PointBox both = ellipse.box(0.55, 1);
  both.radius = (ellipse.point(0.55, 1) - ellipse.point(0.55, -1)).cwiseAbs();
  const Eigen::ArrayXd room = tube.room_for(both, Ellipse::no_spread());
  CHECK(largest_proven(tube, room) == 0);
  CHECK(largest_proven(tube, 1e-4 * room) > 0);
}

TEST_CASE("a tube moved off the curve is rejected, or still holds the arc") {
  const Ellipse ellipse;
  PathTube tube = ellipse.tube();
  const ArcSeries series = ellipse.series(0.55);
  const double height = series.coefficient(0)[2];
  // Down to the base, where the arcs above and below are equally far.
  for (const double part : {1.0, 0.9, 0.7, 0.5}) {
    Eigen::VectorXd shift = Eigen::VectorXd::Zero(4);
    shift[2] = -part * height;
    ArcSeries moved = series;
    moved.coefficient(0) += shift;
    CHECK((!tube.expand(moved) || largest_proven(tube, ellipse.no_room()) == 0));
  }
  ArcSeries moved = series;
  moved.coefficient(0)[2] += 1e-6 * height;
  REQUIRE(tube.expand(moved));
  REQUIRE(largest_proven(tube, ellipse.no_room()) > 0);
  CHECK(tube.locate(ellipse.box(0.55, 1), Ellipse::no_spread()).kind == Kind::inside);
}

TEST_CASE(
    "the start is found with signs changed where the equations are the same with them, else nothing is "
    "said") {
  const Ellipse ellipse;
  PathTube tube = ellipse.tube();
  REQUIRE(tube.expand(ellipse.series(0.55)));
  REQUIRE(largest_proven(tube, 2 * tube.room_for(ellipse.box(0.55, 1), Ellipse::no_spread())) > 0);
  // Unknowns: b.x, c.x, c.y. The base lies on the first axis.
  const auto place = [&](int changed, const SignMasks& turnings) {
    PathData data = ellipse.data;
    data.start = ellipse.box(0.55, 1);
    data.start.mid[changed] *= -1;
    return StartImages(distance_equations(ellipse.system), data, turnings).locate(tube).kind;
  };
  const SignMasks none, of_x(std::vector<SignMask>{0, first_turning, 0}),
      of_y(std::vector<SignMask>{0, 0, first_turning});
  CHECK(place(2, none) == Kind::outside);
  CHECK(place(2, of_x) == Kind::outside);
  CHECK(place(2, of_y) == Kind::inside);
  CHECK(place(1, of_x) == Kind::unknown);
}

TEST_CASE("crossings near a fold are proven, and a touched level is left undecided") {
  const Ellipse ellipse;
  // Where the point lies on the base's line, 1 + 2·semi_major away from the far focus in all.
  const double fold = ((base / 2 + semi_major) - side_at_start) / (side_at_target - side_at_start);
  PathTube tube = ellipse.tube();
  REQUIRE(tube.expand(ellipse.series(base / 2 + semi_major - 1e-7)));
  const double h = largest_proven(tube, ellipse.no_room());
  REQUIRE(h > 1e-4);
  const ParameterRange begin{-0.9 * h, -0.9 * h}, end{0.9 * h, 0.9 * h};
  const double depth = fold - tube.at(-0.9 * h).point.mid[3];
  REQUIRE(depth > 0);
  CHECK_FALSE(crossings_of(tube, fold, begin, end));
  const auto beyond = crossings_of(tube, fold + 0.1 * depth, begin, end);
  REQUIRE(beyond);
  CHECK(beyond->empty());
  const auto before = crossings_of(tube, fold - 0.1 * depth, begin, end);
  REQUIRE(before);
  REQUIRE(before->size() == 2);
  CHECK(before->front().direction == 1);
  CHECK(before->back().direction == -1);
  for (const TubeCrossing& crossing : *before)
    CHECK(tube.at(crossing.s).point.mid[3] == Approx(fold - 0.1 * depth).epsilon(1e-9));
}

TEST_CASE("the whole ellipse is proven, with its two crossings") {
  const Ellipse ellipse;
  for (const int orientation : {1, -1}) {
    SeriesTrackerOptions options;
    options.orientation = orientation;
    CertifiedTracker tracker(ellipse.scene, options, {});
    const TrackedPath path = tracker.run();
    INFO(path.cause);
    CHECK(path.end == TrackedPath::End::closed);
    CHECK(path.proven);
    REQUIRE(path.crossings.size() == 2);
    for (int i = 0; i < 2; ++i) {
      const int half = (i == 0) == (orientation > 0) ? 1 : -1;
      CHECK((path.crossings[i].point - ellipse.point(side_at_target, half)).norm() <= 1e-6);
      CHECK(path.crossings[i].direction == (i == 0 ? 1 : -1));
    }
  }
}

TEST_CASE("a path that touches t = 1 is not proven and says why") {
  ProblemStatement problem = thin_ellipse();
  // The target is the end of the ellipse: both arcs meet there, and t turns back.
  problem.constraints[1].given.value = base / 2 + semi_major;
  problem.constraints[2].given.value = semi_major - base / 2;
  const Scene scene(problem);
  CertifiedTracker tracker(scene, {}, {});
  const TrackedPath path = tracker.run();
  CHECK(path.end == TrackedPath::End::failed);
  CHECK_FALSE(path.proven);
  CHECK_THAT(path.cause, Catch::Contains("touches"));
}

TEST_CASE("a path through a singular point is not proven and says why") {
  ProblemStatement problem = thin_ellipse();
  // The second side is 0.5 + 0.005·(1 − 2t)²: at t = 1/2 the point lies on the base, where two arcs cross.
  problem.constraints[1].given.value = side_at_start;
  problem.constraints[2].given.value = sum_of_sides - side_at_start;
  problem.interpolation = {2, -0.02};
  const Scene scene(problem);
  CertifiedTracker tracker(scene, {}, {});
  const TrackedPath path = tracker.run();
  CHECK(path.end == TrackedPath::End::failed);
  CHECK_FALSE(path.proven);
  CHECK_THAT(path.cause, Catch::Contains("near t = 0.5") || Catch::Contains("near t = 0.49"));
}
