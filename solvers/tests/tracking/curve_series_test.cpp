#include <catch2/catch.hpp>

#include "solvers/construction/derive.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tracking/distance_curve.hpp"
#include "solvers/tracking/plan_curve.hpp"
#include "solvers/tracking/series_tracker.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

/// The problem in the frame in which its plan builds: both curves then have the same coordinates, but for
/// zeros, and the same arc length.
Scene scene_in_plan_frame(ProblemStatement problem) {
  const Scene scene(problem);
  problem.reference = derive_plan(scene, *scene.sketch(), {}).frame();
  return Scene(problem);
}

PlanCurve plan_curve(const Scene& scene, const PlanCurveOptions& options) {
  const Plan plan = derive_plan(scene, *scene.sketch(), options.exchange);
  return PlanCurve(scene, plan, in_plan_frame(scene, plan, *scene.sketch()), options);
}

/// A coefficient or a point of the distance curve in those coordinates.
Eigen::VectorXd as_plan_coordinates(const Scene& scene, const DistanceSystem& system,
                                    const Eigen::VectorXd& y) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(scene.dimension() * scene.point_count() + 1);
  for (int p = 0; p < scene.point_count(); ++p)
    for (int axis = 0; axis < scene.dimension(); ++axis)
      if (system.unknown(p, axis) >= 0) result[scene.dimension() * p + axis] = y[system.unknown(p, axis)];
  result[result.size() - 1] = y[y.size() - 1];
  return result;
}

/// Largest | |p_a − p_b| − a(t) | in long double.
double path_error(const Scene& scene, const Figure& figure, double t) {
  long double worst = 0;
  for (int e = 0; e < scene.constraint_count(); ++e) {
    const auto [a, b] = scene.problem().constraints[e].between;
    const Eigen::Vector3<long double> difference =
        figure.points.col(a).cast<long double>() - figure.points.col(b).cast<long double>();
    const LengthPath& path = scene.length_paths()[e];
    const long double length = path.at_sketch +
                               (path.at_target - path.at_sketch) * static_cast<long double>(t) +
                               path.bend * static_cast<long double>(t) * (1 - static_cast<long double>(t));
    worst = std::max(worst, std::abs(difference.norm() - length));
  }
  return static_cast<double>(worst);
}

/// What the terms of |y'(s)|² − 1 below s^order leave, each relative to the sizes that make it up.
double speed_error(const ArcSeries& series) {
  double worst = 0;
  for (int power = 0; power < series.order(); ++power) {
    double sum = power == 0 ? -1 : 0;
    double size = 1e-12;
    for (int i = 1; i <= power + 1; ++i) {
      const int j = power + 2 - i;
      sum += i * j * series.coefficient(i).dot(series.coefficient(j));
      size += i * j * series.coefficient(i).norm() * series.coefficient(j).norm();
    }
    worst = std::max(worst, std::abs(sum) / size);
  }
  return worst;
}

template <class Curve>
void check_series_at_sketch(const Scene& scene, Curve& curve, int order) {
  for (const int orientation : {1, -1}) {
    ArcSeries series(curve.coordinates(), order);
    REQUIRE(curve.start(orientation, series));
    const Eigen::Index t = curve.coordinates() - 1;
    CHECK(series.coefficient(0)[t] == 0);
    CHECK(series.coefficient(1)[t] * orientation > 0);
    CHECK(path_error(scene, curve.figure(series.coefficient(0)), 0) <= 1e-14);

    CHECK(speed_error(series) <= 1e-13);
    const double step = series.step_for(1e-5);
    double error[2];
    for (const int halving : {0, 1}) {
      Eigen::VectorXd y;
      series.evaluate(std::ldexp(step, -halving), y);
      error[halving] = path_error(scene, curve.figure(y), y[t]);
    }
    CAPTURE(order, step, error[0], error[1]);
    CHECK(error[0] <= 1e-3);
    CHECK(error[1] >= 1e-13);  // else the ratio is one of rounding errors
    CHECK(std::log2(error[0] / error[1]) == Approx(order + 1).margin(0.8));
  }
}

/// max over n of |difference of the coefficients|·step^n
double series_difference(const Scene& scene, const DistanceSystem& system, const ArcSeries& of_distances,
                         const ArcSeries& of_plan, double step) {
  double worst = 0;
  for (int n = 0; n <= of_plan.order(); ++n) {
    const Eigen::VectorXd expected = as_plan_coordinates(scene, system, of_distances.coefficient(n));
    worst = std::max(worst, (expected - of_plan.coefficient(n)).cwiseAbs().maxCoeff() * std::pow(step, n));
  }
  return worst;
}

/// Walks along S with the distance curve and compares the plan curve's series at every point.
void check_series_agree(const ProblemStatement& problem, int steps, double tolerance) {
  const Scene scene = scene_in_plan_frame(problem);
  const DistanceSystem system(scene);
  PlanCurveOptions options;
  DistanceCurve distances(scene, options.order, options.tolerance);
  PlanCurve plan = plan_curve(scene, options);
  ArcSeries here(distances.coordinates(), options.order);
  ArcSeries there = here;
  ArcSeries twin(plan.coordinates(), options.order);
  REQUIRE(distances.start(1, here));
  REQUIRE(plan.start(1, twin));
  double worst = series_difference(scene, system, here, twin, here.step_for(options.tolerance));
  for (int i = 0; i < steps; ++i) {
    Eigen::VectorXd y;
    Eigen::VectorXd tangent;
    // Short enough for the predicted point, where the derivatives are taken, to be the corrected one.
    double step = here.step_for(1e-12);
    for (bool taken = false; !taken; step /= 2) {
      here.evaluate(step, y);
      here.tangent(step, tangent);
      taken = distances.advance(y, tangent, there, false);
      REQUIRE(step > 1e-9);
    }
    std::swap(here, there);
    Eigen::VectorXd twin_y = as_plan_coordinates(scene, system, y);
    REQUIRE(plan.advance(twin_y, as_plan_coordinates(scene, system, tangent), twin, false));
    plan.accept();
    worst = std::max(worst, series_difference(scene, system, here, twin, here.step_for(options.tolerance)));
  }
  CHECK(worst <= tolerance);
}

/// Tracks all of S with both curves: same length, same crossings in the same order.
void check_paths_agree(const ProblemStatement& problem, std::size_t crossings) {
  const Scene scene = scene_in_plan_frame(problem);
  const PlanCurveOptions options;
  DistanceCurve distances(scene, options.order, options.tolerance);
  PlanCurve plan = plan_curve(scene, options);
  const TrackedPath slow = SeriesTracker(distances, SeriesTrackerOptions{}, TrackerContext{}).run();
  const TrackedPath fast = SeriesTracker(plan, SeriesTrackerOptions{}, TrackerContext{}).run();
  REQUIRE(slow.end == TrackedPath::End::closed);
  REQUIRE(fast.end == TrackedPath::End::closed);
  CHECK(fast.length == Approx(slow.length).epsilon(1e-7));
  REQUIRE(slow.crossings.size() == crossings);
  REQUIRE(fast.crossings.size() == crossings);
  for (std::size_t i = 0; i < crossings; ++i) {
    const Figure a = distances.figure(slow.crossings[i].point);
    const Figure b = plan.figure(fast.crossings[i].point);
    CHECK((a.points - b.points).cwiseAbs().maxCoeff() <= 1e-6);
    CHECK(slow.crossings[i].direction == fast.crossings[i].direction);
  }
}

}  // namespace

TEST_CASE("the distance curve's series at the sketch runs along S with speed one") {
  for (const ProblemStatement& problem : {samples::k33(), samples::octahedron()})
    for (const int order : {4, 7, 10}) {
      const Scene scene(problem);
      DistanceCurve curve(scene, order, 1e-9);
      check_series_at_sketch(scene, curve, order);
    }
}

TEST_CASE("the plan curve's series at the sketch runs along S with speed one") {
  for (const ProblemStatement& problem : {samples::k33(), samples::octahedron()})
    for (const int order : {4, 7, 10}) {
      const Scene scene(problem);
      PlanCurveOptions options;
      options.order = order;
      PlanCurve curve = plan_curve(scene, options);
      check_series_at_sketch(scene, curve, order);
    }
}

TEST_CASE("both curves have the same series wherever S is expanded") {
  check_series_agree(samples::k33(), 40, 1e-9);
  check_series_agree(samples::octahedron(), 40, 1e-9);
  RandomNumbers random(1);
  for (int sample = 0; sample < 12; ++sample) {
    const int dimension = 2 + sample % 2;
    CAPTURE(sample);
    check_series_agree(samples::random_problem(dimension, 5 + random.index(4), random), 15, 1e-9);
  }
}

TEST_CASE("both curves lead once around S with the same length and the same crossings") {
  check_paths_agree(samples::k33(), 2);
  check_paths_agree(samples::octahedron(), 4);
}

TEST_CASE("a point moved off the curve by less than the tolerance is corrected back onto it") {
  const Scene scene(samples::octahedron());
  const PlanCurveOptions options;
  DistanceCurve distances(scene, options.order, options.tolerance);
  PlanCurve plan = plan_curve(scene, options);
  RandomNumbers random(2);
  const auto check = [&](auto& curve) {
    ArcSeries series(curve.coordinates(), options.order);
    REQUIRE(curve.start(1, series));
    Eigen::VectorXd y;
    Eigen::VectorXd tangent;
    const double step = series.step_for(1e-12);
    series.evaluate(step, y);
    series.tangent(step, tangent);
    for (double& value : y) value += random.uniform(-1e-9, 1e-9);
    REQUIRE(curve.advance(y, tangent, series, false));
    CHECK(path_error(scene, curve.figure(y), y[y.size() - 1]) <= 1e-14);
    CHECK(series.coefficient(0) == y);

    y += 1e-3 * tangent.reverse();
    CHECK_FALSE(curve.advance(y, tangent, series, false));
    curve.reject();
  };
  check(distances);
  check(plan);
}

TEST_CASE("a singular sketch is refused") {
  // Flat: the derivatives of all lengths vanish across the line, and the lengths of p3 grow alike.
  Eigen::Matrix3Xd sketch = Eigen::Matrix3Xd::Zero(3, 4);
  sketch.row(0) << 0, 2, 1, 3;
  const samples::Edges edges{{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}};
  const Scene scene(samples::between(2, edges, sketch, 2 * sketch));
  DistanceCurve curve(scene, 8, 1e-9);
  ArcSeries series(curve.coordinates(), 8);
  CHECK_FALSE(curve.start(1, series));
}
