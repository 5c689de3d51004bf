#include "solvers/tracking/plan_curve.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "solvers/construction/derive.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using samples::RandomNumbers;

namespace {

using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// Everything that the plan leaves implicit, as one system in all coordinates and t: the constraints that the
/// plan uses, its driven spheres, and the zeros of its frame. Its solutions are the columns that the plan's
/// recursion must give.
class FullSystem {
 public:
  FullSystem(const Scene& scene, const PlanCurve& curve, double t)
      : scene_(scene), plan_(curve.plan()), points_(curve.points().cast<long double>()), t_(t) {}

  /// Derivatives of all coordinates and t by (t, κ_1, …, κ_d).
  Matrix sensitivity() const {
    const int d = plan_.driving_parameters();
    Matrix matrix = Matrix::Zero(unknowns(), unknowns());
    Matrix right = Matrix::Zero(unknowns(), d + 1);
    Eigen::Index r = 0;
    matrix(r, unknowns() - 1) = 1;
    right(r++, 0) = 1;
    int driven = 0;
    for (const Instruction& instruction : plan_.instructions()) {
      for (int i = 0; i < instruction.count; ++i) {
        const PlanSphere& sphere = instruction.spheres[i];
        if (sphere.is_driven()) {
          right(r, ++driven) = 1;
          add_normal(matrix, r++, instruction.place,
                     points_.col(instruction.place) - sphere.reference.cast<long double>());
        } else {
          matrix.row(r++) = gradient(sphere.constraint);
        }
      }
      for (int axis = instruction.count; axis < scene_.dimension(); ++axis)
        matrix(r++, scene_.dimension() * instruction.place + axis) = 1;
    }
    REQUIRE(r == unknowns());
    return matrix.fullPivLu().solve(right);
  }

  /// Of the removed constraints by (t, κ_1, …, κ_d).
  Matrix reduced_jacobian() const {
    Matrix rows(plan_.driving_parameters(), unknowns());
    for (Eigen::Index i = 0; i < rows.rows(); ++i) rows.row(i) = gradient(plan_.removed()[i]);
    return rows * sensitivity();
  }

  /// f of a constraint.
  long double residual(int constraint) const {
    const auto [a, b] = scene_.problem().constraints[constraint].between;
    const long double length = scene_.length_paths()[constraint].value(t_);
    return ((points_.col(a) - points_.col(b)).squaredNorm() - length * length) / 2;
  }

 private:
  Eigen::Index unknowns() const { return scene_.dimension() * scene_.point_count() + 1; }

  void add_normal(Matrix& matrix, Eigen::Index r, int point,
                  const Eigen::Vector3<long double>& normal) const {
    for (int axis = 0; axis < scene_.dimension(); ++axis)
      matrix(r, scene_.dimension() * point + axis) += normal[axis];
  }

  Matrix gradient(int constraint) const {
    Matrix row = Matrix::Zero(1, unknowns());
    const auto [a, b] = scene_.problem().constraints[constraint].between;
    const Eigen::Vector3<long double> difference = points_.col(a) - points_.col(b);
    add_normal(row, 0, a, difference);
    add_normal(row, 0, b, -difference);
    const LengthPath& path = scene_.length_paths()[constraint];
    row(0, unknowns() - 1) = -static_cast<long double>(path.value(t_)) * path.slope(t_);
    return row;
  }

  const Scene& scene_;
  const Plan& plan_;
  Eigen::Matrix3X<long double> points_;
  double t_;
};

/// Largest difference relative to the largest entry of the exact matrix, or to 1.
template <class Computed>
double difference(const Computed& computed, const Matrix& exact) {
  if (exact.size() == 0) return 0;
  const Matrix error = Matrix(computed.template cast<long double>()) - exact;
  return static_cast<double>(error.cwiseAbs().maxCoeff() / std::max(1.0L, exact.cwiseAbs().maxCoeff()));
}

struct Sample {
  Scene scene;
  PlanCurve curve;
};

/// A plan changed at a few random figures, so that some of its instructions are exchanged, then brought to
/// the sketch.
Sample exchanged_sample(int dimension, const ExchangeRule& rule, RandomNumbers& random) {
  Scene scene(samples::random_problem(dimension, 5 + random.index(4), random));
  Plan plan = derive_plan(scene, *scene.sketch(), rule);
  for (int i = 0; i < 3; ++i) {
    const Figure figure{random.points(dimension, scene.point_count(), 1), {}};
    change_plan(plan, rule, in_plan_frame(scene, plan, figure).points);
  }
  const Figure sketch = in_plan_frame(scene, plan, *scene.sketch());
  change_plan(plan, rule, sketch.points);
  PlanCurveOptions options;
  options.exchange = rule;
  return {scene, PlanCurve(scene, plan, sketch, options)};
}

SolveReport solved_by_rcp(const Scene& scene, const OptionMap& given) {
  const auto strategies = all_strategies();
  const StrategyEntry& entry = *std::find_if(strategies.begin(), strategies.end(),
                                             [](const StrategyEntry& one) { return one.name == "rcp"; });
  return entry.make(complete_options(entry, given))->solve(scene);
}

}  // namespace

TEST_CASE("the plan at the sketch's parameters builds the sketch") {
  RandomNumbers random(1);
  double worst = 0;
  for (int sample = 0; sample < 60; ++sample) {
    Sample s = exchanged_sample(2 + sample % 2, {0.2, true}, random);
    const Eigen::Matrix3Xd sketch = in_plan_frame(s.scene, s.curve.plan(), *s.scene.sketch()).points;
    s.curve.read_parameters(sketch, 0);
    REQUIRE(s.curve.evaluate());
    worst = std::max(worst, (s.curve.points() - sketch).cwiseAbs().maxCoeff());
  }
  CHECK(worst <= 1e-12);
}

TEST_CASE("derivatives through the plan are the kernel of the constraints that it keeps") {
  RandomNumbers random(2);
  double worst_sensitivity = 0;
  double worst_jacobian = 0;
  double worst_residual = 0;
  int most_driving = 0;
  int judged = 0;
  for (int sample = 0; sample < 150; ++sample) {
    Sample s = exchanged_sample(2 + sample % 2, {0.2, true}, random);
    PlanCurve& curve = s.curve;
    curve.read_parameters(in_plan_frame(s.scene, curve.plan(), *s.scene.sketch()).points, 0);
    // Somewhere near the sketch, off S.
    const double t = random.uniform(-0.02, 0.02);
    curve.parameters()[0] = t;
    for (Eigen::Index j = 1; j < curve.parameters().size(); ++j)
      curve.parameters()[j] *= random.uniform(0.98, 1.02);
    if (!curve.evaluate()) continue;
    if (boundary_distance(curve.plan(), {0.2, true}, curve.points()) < 0.1) continue;
    ++judged;
    most_driving = std::max(most_driving, curve.plan().driving_parameters());
    curve.differentiate();
    const FullSystem full(s.scene, curve, t);
    worst_sensitivity = std::max(worst_sensitivity, difference(curve.sensitivity(), full.sensitivity()));
    worst_jacobian = std::max(worst_jacobian, difference(curve.reduced_jacobian(), full.reduced_jacobian()));

    Eigen::VectorXd f(curve.plan().driving_parameters());
    curve.residual(f);
    for (Eigen::Index i = 0; i < f.size(); ++i) {
      const auto exact = static_cast<double>(full.residual(curve.plan().removed()[i]));
      worst_residual = std::max(worst_residual, std::abs(f[i] - exact));
    }
  }
  CHECK(judged >= 60);
  CHECK(most_driving >= 4);
  CHECK(worst_sensitivity <= 1e-12);
  CHECK(worst_jacobian <= 1e-12);
  CHECK(worst_residual <= 1e-14);
}

TEST_CASE("derivatives through the plan agree with differences of its evaluations") {
  RandomNumbers random(3);
  double worst = 0;
  int judged = 0;
  for (int sample = 0; sample < 30; ++sample) {
    Sample s = exchanged_sample(2 + sample % 2, {0.2, true}, random);
    PlanCurve& curve = s.curve;
    curve.read_parameters(in_plan_frame(s.scene, curve.plan(), *s.scene.sketch()).points, 0);
    if (!curve.evaluate()) continue;
    ++judged;
    curve.differentiate();
    const Eigen::MatrixXd sensitivity = curve.sensitivity();
    const int d = s.scene.dimension();
    for (Eigen::Index j = 0; j < curve.parameters().size(); ++j) {
      constexpr double step = 1e-6;
      const double middle = curve.parameters()[j];
      curve.parameters()[j] = middle + step;
      REQUIRE(curve.evaluate());
      const Eigen::Matrix3Xd above = curve.points();
      curve.parameters()[j] = middle - step;
      REQUIRE(curve.evaluate());
      const Eigen::MatrixXd slope = ((above - curve.points()) / (2 * step)).topRows(d);
      curve.parameters()[j] = middle;
      const Eigen::VectorXd column = sensitivity.col(j).head(slope.size());
      const double size = std::max(1.0, column.cwiseAbs().maxCoeff());
      // The third derivative grows faster than the first where a plan is sensitive.
      worst = std::max(worst, (slope.reshaped() - column).cwiseAbs().maxCoeff() / std::pow(size, 3));
    }
  }
  CHECK(judged >= 20);
  CHECK(worst <= 1e-6);
}

TEST_CASE("a plan without driving parameters depends on t alone") {
  Eigen::Matrix3Xd sketch = Eigen::Matrix3Xd::Zero(3, 3);
  sketch.col(1) << 3, 0, 0;
  sketch.col(2) << 1, 2, 0;
  Eigen::Matrix3Xd target = sketch;
  target.col(2) << 2, 1.5, 0;
  const Scene scene(samples::between(2, {{0, 1}, {0, 2}, {1, 2}}, sketch, target));
  const Plan plan = derive_plan(scene, *scene.sketch(), {});
  PlanCurve curve(scene, plan, in_plan_frame(scene, plan, *scene.sketch()), {});
  ArcSeries series(curve.coordinates(), 8);
  REQUIRE(curve.start(1, series));
  CHECK(curve.reduced_jacobian().rows() == 0);
  CHECK(curve.parameters().size() == 1);
  curve.differentiate();
  CHECK(difference(curve.sensitivity(), FullSystem(scene, curve, 0).sensitivity()) <= 1e-15);
}

TEST_CASE("a step taken back leaves the plan as it was") {
  const Scene scene(samples::octahedron());
  PlanCurveOptions options;
  options.exchange.alpha = 0.4;
  const Plan plan = derive_plan(scene, *scene.sketch(), options.exchange);
  PlanCurve curve(scene, plan, in_plan_frame(scene, plan, *scene.sketch()), options);
  ArcSeries series(curve.coordinates(), options.order);
  ArcSeries next = series;
  REQUIRE(curve.start(1, series));
  int taken_back = 0;
  for (int i = 0; i < 400 && taken_back < 3; ++i) {
    Eigen::VectorXd y;
    Eigen::VectorXd tangent;
    const double step = series.step_for(options.tolerance) / 4;
    series.evaluate(step, y);
    series.tangent(step, tangent);
    const auto before = describe_plan(scene, curve.plan());
    const std::int64_t changes = curve.work().plan_changes;
    Eigen::VectorXd attempt = y;
    REQUIRE(curve.advance(attempt, tangent, next, false));
    if (describe_plan(scene, curve.plan()) != before) {
      CHECK(curve.work().plan_changes == changes + 1);
      curve.reject();
      CHECK(describe_plan(scene, curve.plan()) == before);
      CHECK(curve.work().plan_changes == changes);
      ++taken_back;
      REQUIRE(curve.advance(y, tangent, next, false));
    }
    curve.accept();
    std::swap(series, next);
  }
  CHECK(taken_back == 3);
}

TEST_CASE("the plans of a path are noted where they change, on the path") {
  for (const ProblemStatement& problem : {samples::octahedron(), samples::k33()}) {
    const Scene scene(problem);
    for (const std::string mode : {"fast", "paper"}) {
      CAPTURE(mode);
      const SolveReport report = solved_by_rcp(scene, {{"mode", mode}});
      REQUIRE(report.status == SolveStatus::complete);
      const std::vector<PlanUse>& plans = report.paths.front().plans;
      CHECK(plans.size() == static_cast<std::size_t>(report.work.plan_changes) + 1);
      CHECK(plans.front().t == 0);
      for (const PlanUse& use : plans) {
        CHECK(use.removed.size() <= static_cast<std::size_t>(*report.work.max_driving_parameters));
        for (int c = 0; c < scene.constraint_count(); ++c) {
          const auto [a, b] = scene.problem().constraints[static_cast<std::size_t>(c)].between;
          const double length = scene.length_paths()[static_cast<std::size_t>(c)].value(use.t);
          CHECK((use.figure.points.col(a) - use.figure.points.col(b)).norm() == Approx(length).margin(1e-6));
        }
      }
    }
  }
}

TEST_CASE("derivatives by the whole plan have the bits of those by a part of it") {
  const Scene scene(samples::octahedron());
  const SolveReport part = solved_by_rcp(scene, {{"mode", "paper"}});
  const SolveReport whole = solved_by_rcp(scene, {{"mode", "paper"}, {"derivatives", "whole"}});
  REQUIRE(part.candidates.size() == whole.candidates.size());
  for (std::size_t i = 0; i < part.candidates.size(); ++i)
    CHECK(part.candidates[i].figure.points == whole.candidates[i].figure.points);
  CHECK(part.work.partial_evaluations > 0);
  CHECK(whole.work.partial_evaluations == 0);
  CHECK(whole.work.evaluations == part.work.evaluations + part.work.partial_evaluations);
}
