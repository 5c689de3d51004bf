/// Times what a step on S is made of: residual, Jacobian, plan evaluation, derivatives through the plan, and
/// one whole step, at the sketch of each of the four published problems.

#include <benchmark/benchmark.h>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/construction/derive.hpp"
#include "solvers/tracking/distance_curve.hpp"
#include "solvers/tracking/plan_curve.hpp"
#include "solvers/tracking/series_curve.hpp"
#include "solvers/tracking/series_tracker.hpp"

namespace {

using namespace gcs;

const Scene& scene_of(benchmark::State& state) {
  static constexpr std::array<const char*, 4> ids{"octahedron", "disulfide", "dodecagon", "icosahedron"};
  static const std::array<Scene, 4> scenes{Scene(load_instance(ids[0])), Scene(load_instance(ids[1])),
                                           Scene(load_instance(ids[2])), Scene(load_instance(ids[3]))};
  const auto index = static_cast<std::size_t>(state.range(0));
  state.SetLabel(ids[index]);
  return scenes[index];
}

DistanceCurve distance_curve(const Scene& scene) {
  const SeriesTrackerOptions options;
  return {scene, options.order, options.tolerance};
}

PlanCurve plan_curve(const Scene& scene) {
  const Plan plan = first_plan(scene, ExchangeRule{});
  return {scene, plan, in_plan_frame(scene, plan, *scene.sketch()), PlanCurveOptions{}};
}

void full_space_residual(benchmark::State& state) {
  const Scene& scene = scene_of(state);
  DistanceCurve curve = distance_curve(scene);
  ArcSeries series(curve.coordinates(), SeriesTrackerOptions{}.order);
  curve.start(1, series);
  const Eigen::VectorXd y = series.coefficient(0);
  Eigen::VectorXd f(scene.constraint_count());
  for (auto _ : state) {
    curve.residual(y, f, false);
    benchmark::DoNotOptimize(f.data());
  }
}

void full_space_jacobian(benchmark::State& state) {
  DistanceCurve curve = distance_curve(scene_of(state));
  ArcSeries series(curve.coordinates(), SeriesTrackerOptions{}.order);
  curve.start(1, series);
  const Eigen::VectorXd y = series.coefficient(0);
  for (auto _ : state) {
    curve.jacobian(y);
    benchmark::ClobberMemory();
  }
}

void plan_evaluation(benchmark::State& state) {
  PlanCurve curve = plan_curve(scene_of(state));
  ArcSeries series(curve.coordinates(), PlanCurveOptions{}.order);
  curve.start(1, series);
  for (auto _ : state) benchmark::DoNotOptimize(curve.evaluate());
}

void plan_derivatives(benchmark::State& state) {
  PlanCurve curve = plan_curve(scene_of(state));
  ArcSeries series(curve.coordinates(), PlanCurveOptions{}.order);
  curve.start(1, series);
  for (auto _ : state) {
    curve.differentiate();
    benchmark::ClobberMemory();
  }
}

/// The first step from the sketch: prediction, correction, factorisation and the next series.
template <SeriesCurve Curve>
void time_step(benchmark::State& state, Curve& curve) {
  const SeriesTrackerOptions options;
  ArcSeries here(curve.coordinates(), options.order);
  ArcSeries there = here;
  curve.start(1, here);
  const double step = std::min(options.step_max, here.step_for(options.tolerance));
  Eigen::VectorXd y;
  Eigen::VectorXd tangent;
  for (auto _ : state) {
    here.evaluate(step, y);
    here.tangent(step, tangent);
    benchmark::DoNotOptimize(curve.advance(y, tangent, there, false));
    curve.reject();
  }
}

void full_space_step(benchmark::State& state) {
  DistanceCurve curve = distance_curve(scene_of(state));
  time_step(state, curve);
}

void rcp_step(benchmark::State& state) {
  PlanCurve curve = plan_curve(scene_of(state));
  time_step(state, curve);
}

BENCHMARK(full_space_residual)->DenseRange(0, 3);
BENCHMARK(full_space_jacobian)->DenseRange(0, 3);
BENCHMARK(full_space_step)->DenseRange(0, 3);
BENCHMARK(plan_evaluation)->DenseRange(0, 3);
BENCHMARK(plan_derivatives)->DenseRange(0, 3);
BENCHMARK(rcp_step)->DenseRange(0, 3);

}  // namespace
