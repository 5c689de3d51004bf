#include "solvers/tracking/path_report.hpp"

#include <catch2/catch.hpp>
#include <limits>

#include "solvers/tests/sample_problems.hpp"

using namespace gcs;

namespace {

/// A tracker's point is its figure, then t.
Figure figure_of(const Eigen::VectorXd& y) {
  Figure figure{Eigen::Matrix3Xd::Zero(3, 3), {}};
  figure.points.topRows(2) = Eigen::Map<const Eigen::MatrixXd>(y.data(), 2, 3);
  return figure;
}

Scene triangle() {
  Eigen::Matrix3Xd places = Eigen::Matrix3Xd::Zero(3, 3);
  places.col(1) << 1, 0, 0;
  places.col(2) << 0.5, 0.75, 0;
  return Scene(samples::between(2, {{0, 1}, {0, 2}, {1, 2}}, places, places));
}

/// Where the triangle's sides are far from those given.
Eigen::VectorXd no_solution() { return (Eigen::VectorXd(7) << 0, 0, 5, 0, 2, 3, 1).finished(); }

SolveReport report_of(const TrackedPath& path) { return path_report(triangle(), path, figure_of); }

}  // namespace

TEST_CASE("the reason why a path failed is not replaced by what its crossings lack") {
  TrackedPath path;
  path.end = TrackedPath::End::failed;
  path.cause = step_too_small(0.5);
  path.crossings.push_back({no_solution(), 1, 0.5});
  const SolveReport report = report_of(path);
  CHECK(report.status == SolveStatus::gave_up);
  CHECK(report.reason == path.cause);
}

TEST_CASE("of several shortcomings of a path the first one is named") {
  TrackedPath path;
  path.end = TrackedPath::End::closed;
  path.touches.push_back({no_solution(), no_solution(), 1, 0.25, std::numeric_limits<double>::infinity()});
  const SolveReport touched = report_of(path);
  CHECK(touched.status == SolveStatus::partial);
  path.crossings.push_back({no_solution(), 1, 0.5});
  CHECK(report_of(path).reason == touched.reason);
  path.touches.clear();
  CHECK(report_of(path).reason != touched.reason);
}
