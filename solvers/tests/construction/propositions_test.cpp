/// What [I] proves of construction plans, as properties of random scenes. (Proposition 2 is in boundary_test.cpp; the
/// termination of Algorithm 1 is what every closed path shows.)

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "solvers/construction/derive.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/tests/sample_problems.hpp"
#include "solvers/tracking/paper_homotopies.hpp"
#include "solvers/tracking/plan_curve.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

std::vector<int> branch_of(const Plan& plan, const Eigen::Matrix3Xd& points) {
  std::vector<int> branch;
  for (const Instruction& instruction : plan.instructions())
    if (instruction.count > 0) branch.push_back(side_of(instruction, points));
  return branch;
}

/// [b]φ(φ'(X)) on the branch whose bits are those of `number`; false where it builds nothing.
bool build_on(Plan plan, int number, const Scene& scene, const Eigen::Matrix3Xd& x, Eigen::Matrix3Xd& built) {
  std::vector<double> driven;
  for (Instruction& instruction : plan.instructions()) {
    if (instruction.count > 1) {  // the plan's first two points are at the origin and at x > 0
      instruction.side = (number & 1) != 0 ? -1 : 1;
      number >>= 1;
    }
    for (int i = 0; i < instruction.count; ++i)
      if (instruction.spheres[i].is_driven()) driven.push_back(radius_of(instruction, i, x));
  }
  const auto radius = [&](const PlanSphere& sphere, int j) {
    if (sphere.is_driven()) return driven[static_cast<std::size_t>(j)];
    const auto [a, b] = scene.problem().constraints[sphere.constraint].between;
    return (x.col(a) - x.col(b)).norm();
  };
  built = Eigen::Matrix3Xd::Zero(3, x.cols());
  return evaluate_plan(plan, 0, radius, built);
}

int branches_that_build(const Plan& plan, const Scene& scene, const Eigen::Matrix3Xd& x, double within) {
  int found = 0;
  const int choices = static_cast<int>(plan.instructions().size()) - 2;
  for (int number = 0; number < 1 << choices; ++number)
    if (Eigen::Matrix3Xd built; build_on(plan, number, scene, x, built))
      found += (built - x).cwiseAbs().maxCoeff() <= within ? 1 : 0;
  return found;
}

double least_gamma(const Plan& plan, const Eigen::Matrix3Xd& points) {
  return boundary_distance(plan, {0.1, false}, points);
}

/// Moves the point of the instruction to the height `h` above the line or plane of its centres.
void flatten(const Instruction& instruction, double h, Eigen::Matrix3Xd& points) {
  const Eigen::Vector3d origin = center_of(instruction.spheres[0], points);
  Eigen::Matrix3Xd span(3, instruction.count - 1);
  for (int i = 1; i < instruction.count; ++i)
    span.col(i - 1) = center_of(instruction.spheres[i], points) - origin;
  const Eigen::Vector3d arm = points.col(instruction.place) - origin;
  const Eigen::Vector3d within =
      span * (span.transpose() * span).ldlt().solve(Eigen::VectorXd(span.transpose() * arm));
  points.col(instruction.place) = origin + within + h * (arm - within).normalized();
}

/// Derivatives of all squared distances, halved, along a motion of the points.
Eigen::VectorXd stretches(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& moves) {
  std::vector<double> all;
  for (Eigen::Index a = 0; a < points.cols(); ++a)
    for (Eigen::Index b = a + 1; b < points.cols(); ++b)
      all.push_back((points.col(a) - points.col(b)).dot(moves.col(a) - moves.col(b)));
  return Eigen::Map<Eigen::VectorXd>(all.data(), static_cast<Eigen::Index>(all.size()));
}

/// Moves of the points, and of t, along H at the sketch: the kernel of the Jacobian in all coordinates.
std::pair<Eigen::Matrix3Xd, double> tangent_of_h(const Scene& scene, const Reference& frame,
                                                 const Figure& sketch) {
  const DistanceSystem system(scene, frame);
  Eigen::MatrixXd jacobian(system.equations(), system.unknowns() + 1);
  system.jacobian(sketch.points, jacobian);
  const auto lengths = scene.length_paths();
  for (int e = 0; e < system.equations(); ++e)
    jacobian(e, system.unknowns()) = -lengths[e].value(0) * lengths[e].slope(0);
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(jacobian);
  REQUIRE(lu.rank() == system.equations());
  const Eigen::VectorXd kernel = lu.kernel().col(0);
  Eigen::Matrix3Xd moves = Eigen::Matrix3Xd::Zero(3, scene.point_count());
  for (int p = 0; p < scene.point_count(); ++p)
    for (int axis = 0; axis < 3; ++axis)
      if (const int unknown = system.unknown(p, axis); unknown >= 0) moves(axis, p) = kernel[unknown];
  return {moves, kernel[system.unknowns()]};
}

}  // namespace

TEST_CASE("Remark 1: one branch builds a figure without a boundary configuration, two or more one with it") {
  RandomNumbers random(31);
  int flat = 0;
  for (int sample = 0; sample < 60; ++sample) {
    const int dimension = 2 + sample % 2;
    const Scene scene(samples::random_problem(dimension, 5 + random.index(3), random));
    const Plan plan = derive_plan(scene, *scene.sketch(), {});
    Eigen::Matrix3Xd x = in_plan_frame(scene, plan, *scene.sketch()).points;
    CAPTURE(sample);
    if (least_gamma(plan, x) > 1e-3) CHECK(branches_that_build(plan, scene, x, 1e-7) == 1);
    // The last instruction: what it places carries no other point.
    const Instruction& last = plan.instructions().back();
    if (last.count < 2) continue;
    flatten(last, 1e-6, x);
    CHECK(branches_that_build(plan, scene, x, 1e-5) >= 2);
    ++flat;
  }
  CHECK(flat > 40);
}

TEST_CASE("Lemma 1: away from boundary configurations the paths of H and of H_R have one tangent") {
  RandomNumbers random(32);
  for (int sample = 0; sample < 60; ++sample) {
    const int dimension = 2 + sample % 2;
    const Scene scene(samples::random_problem(dimension, 5 + random.index(4), random));
    const Plan plan = derive_plan(scene, *scene.sketch(), {});
    const Figure sketch = in_plan_frame(scene, plan, *scene.sketch());
    if (least_gamma(plan, sketch.points) < 0.05) continue;
    PlanCurve curve(scene, plan, sketch, {});
    curve.read_parameters(sketch.points, 0);
    REQUIRE(curve.evaluate());
    curve.differentiate();
    const int d = plan.driving_parameters();
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(Eigen::MatrixXd(curve.reduced_jacobian()));
    REQUIRE((d == 0 || lu.rank() == d));
    const Eigen::VectorXd reduced =
        d == 0 ? Eigen::VectorXd(Eigen::VectorXd::Unit(1, 0)) : Eigen::VectorXd(lu.kernel().col(0));
    const Eigen::VectorXd lifted = curve.sensitivity() * reduced;
    Eigen::Matrix3Xd moves = Eigen::Matrix3Xd::Zero(3, scene.point_count());
    moves.topRows(dimension) = lifted.head(lifted.size() - 1).reshaped(dimension, scene.point_count());
    const auto [expected, t] = tangent_of_h(scene, plan.frame(), sketch);
    Eigen::VectorXd of_plan = stretches(sketch.points, moves), of_h = stretches(sketch.points, expected);
    of_plan.conservativeResize(of_plan.size() + 1);
    of_h.conservativeResize(of_h.size() + 1);
    of_plan[of_plan.size() - 1] = reduced[0];
    of_h[of_h.size() - 1] = t;
    CAPTURE(sample, dimension, d);
    CHECK(std::abs(of_plan.normalized().dot(of_h.normalized())) == Approx(1).epsilon(1e-9));
  }
}

TEST_CASE("Proposition 1: along S the branch changes at boundary configurations alone") {
  RandomNumbers random(33);
  constexpr double step = 0.01;
  int changes = 0;
  for (int sample = 0; sample < 10; ++sample) {
    const int dimension = 2 + sample % 2;
    const Scene scene(samples::random_problem(dimension, 5 + random.index(2), random));
    const Plan plan = derive_plan(scene, *scene.sketch(), {});
    PaperDistanceHomotopy homotopy(scene);
    EulerNewtonTracker tracker(homotopy, {.step_max = step, .max_steps = 20'000, .keep_points = true}, {});
    const TrackedPath path = tracker.run();
    std::vector<int> last;
    double last_gamma = 0;
    for (const Eigen::VectorXd& y : path.points) {
      const Eigen::Matrix3Xd points = in_plan_frame(scene, plan, homotopy.figure(y)).points;
      const std::vector<int> branch = branch_of(plan, points);
      const double gamma = least_gamma(plan, points);
      if (!last.empty() && branch != last) {
        ++changes;
        // The height above the line or plane of the centres goes through 0 with S, as fast as S at most.
        CAPTURE(sample, gamma, last_gamma);
        CHECK(std::min(gamma, last_gamma) <= 20 * step / scene.size());
      }
      last = branch;
      last_gamma = gamma;
    }
  }
  CHECK(changes > 5);
}
