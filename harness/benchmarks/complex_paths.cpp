/// Times the following of complex paths, for each instruction set and number of threads: legs between the
/// lengths of random placements. Counters: paths and steps per second and thread, arithmetic per second and
/// thread, a fused multiply-add being two operations. `multiply_add_peak` is what this machine does of those
/// at most with each set, in registers alone. SIMD's gain is the ratio of rows of one thread, the second
/// core's of two rows of one set.
///   gcsbench_benchmarks --benchmark_filter='complex_paths|multiply_add'

#include <benchmark/benchmark.h>
#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <array>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/homotopies/leg_tracking.hpp"
#include "solvers/model/distance_system.hpp"

namespace {

using namespace gcs;

constexpr std::array<const char*, 3> ids{"disulfide", "dodecagon", "icosahedron"};
constexpr std::array<InstructionSet, 3> sets{InstructionSet::portable, InstructionSet::avx2,
                                             InstructionSet::avx512};
constexpr double of_complex_product = 8, of_real_times_complex = 4, of_complex_inverse = 8;
constexpr double inner_products_of_fit = 5;
constexpr double of_compensated_square = 36;  // with the error of its difference

/// Floating-point operations of one step (lane_kernel.hpp): prediction, Jacobian with its factors, a residual
/// and a solution of the linear system for the correction, right-hand sides and solutions for the series, and
/// two fits of its tail.
double operations_per_step(const SquareSystem& system, const Elimination& elimination, int order) {
  auto elimination_products = static_cast<double>(elimination.upper.size());
  for (int k = 0; k < system.unknowns; ++k) {
    const double lower = elimination.steps[k + 1].first_lower - elimination.steps[k].first_lower;
    const double upper = elimination.steps[k + 1].first_upper - elimination.steps[k].first_upper;
    elimination_products += lower * (upper + 1);
  }
  const double solution_products =
      static_cast<double>(elimination.lower.size() + elimination.upper.size()) + system.unknowns;
  double convolution_products = 0;
  for (int k = 1; k <= order; ++k) convolution_products += k / 2;
  const auto differences = static_cast<double>(system.differences.size());
  const double tail_products = 2 * inner_products_of_fit * system.unknowns;
  return of_real_times_complex * order * system.unknowns + of_complex_product * elimination_products +
         of_complex_inverse * system.unknowns + of_compensated_square * differences +
         of_complex_product *
             ((order + 1) * solution_products + convolution_products * differences + tail_products);
}

Route straight(const ComplexVectorX& from, const ComplexVectorX& to) {
  const ComplexVectorX zero(from.size());
  Route route{{from, to, zero, zero}, to};
  for (std::size_t e = 0; e < from.size(); ++e) route.coefficients[1][e] -= from[e];
  return route;
}

/// Legs from random placements, each between its own lengths and those of another one.
struct Legs {
  explicit Legs(const char* id)
      : system(square_system(DistanceSystem(Scene(load_instance(id))))),
        elimination(order_elimination(system, random)) {
    constexpr int count = 256;
    for (int i = 0; i < count; ++i) {
      starts.push_back(random_complex_vector(system.unknowns, random));
      const ComplexVectorX end = random_complex_vector(system.unknowns, random);
      routes.push_back(straight(squares_at(system, starts.back()), squares_at(system, end)));
    }
    for (int i = 0; i < count; ++i) legs.push_back({starts[i].data(), &routes[i]});
  }

  std::mt19937_64 random{1};
  SquareSystem system;
  Elimination elimination;
  std::vector<ComplexVectorX> starts;
  std::vector<Route> routes;
  std::vector<Leg> legs;
};

void complex_paths(benchmark::State& state) {
  const char* id = ids[static_cast<std::size_t>(state.range(0))];
  const InstructionSet set = sets[static_cast<std::size_t>(state.range(1))];
  state.SetLabel(std::string(id) + " " + std::string(name(set)));
  if (!is_available(set)) {
    state.SkipWithError("this machine does not have these instructions");
    return;
  }
  const Legs legs(id);
  const int threads = static_cast<int>(state.range(2));
  const TrackingOptions options;
  LegTracking tracking(legs.system, legs.elimination, {options, set, threads});
  WorkCounters work;
  for (auto _ : state)
    benchmark::DoNotOptimize(tracking
                                 .follow(
                                     legs.legs, [] { return false; }, work)
                                 .data());
  const double paths = static_cast<double>(state.iterations()) * static_cast<double>(legs.legs.size());
  const double steps = static_cast<double>(work.factorisations);
  const double operations = steps * operations_per_step(legs.system, legs.elimination, options.order);
  for (const auto& [label, count] : {std::pair{"paths", paths}, {"steps", steps}, {"operations", operations}})
    state.counters[label] = benchmark::Counter(count / threads, benchmark::Counter::kIsRate);
}

BENCHMARK(complex_paths)
    ->ArgsProduct({{0, 1, 2}, {0, 1, 2}, {1, 2}})
    ->ArgNames({"scene", "set", "threads"})
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

#if defined(__x86_64__)
// Unrolled, all sums stay in registers; there are so many that none waits for its last result.
constexpr int repeats = 1000, chains = 12;

void count_operations(benchmark::State& state, std::size_t lanes) {
  const double operations = 2.0 * repeats * chains * static_cast<double>(lanes);
  state.counters["operations"] =
      benchmark::Counter(operations * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

[[gnu::target("avx2,fma")]] void repeat_avx2(benchmark::State& state) {
  const __m256d factor = _mm256_set1_pd(1.000000001), summand = _mm256_set1_pd(1e-9);
  __m256d sums[chains] = {};
  for (auto _ : state) {
    for (int repeat = 0; repeat < repeats; ++repeat)
#pragma GCC unroll 12
      for (int i = 0; i < chains; ++i) sums[i] = _mm256_fmadd_pd(sums[i], factor, summand);
    benchmark::DoNotOptimize(sums);
  }
  count_operations(state, 4);
}

[[gnu::target("avx512f")]] void repeat_avx512(benchmark::State& state) {
  const __m512d factor = _mm512_set1_pd(1.000000001), summand = _mm512_set1_pd(1e-9);
  __m512d sums[chains] = {};
  for (auto _ : state) {
    for (int repeat = 0; repeat < repeats; ++repeat)
#pragma GCC unroll 12
      for (int i = 0; i < chains; ++i) sums[i] = _mm512_fmadd_pd(sums[i], factor, summand);
    benchmark::DoNotOptimize(sums);
  }
  count_operations(state, 8);
}

void multiply_add_peak(benchmark::State& state) {
  const InstructionSet set = sets[static_cast<std::size_t>(state.range(0))];
  state.SetLabel(std::string(name(set)));
  if (!is_available(set))
    state.SkipWithError("this machine does not have these instructions");
  else
    set == InstructionSet::avx512 ? repeat_avx512(state) : repeat_avx2(state);
}

BENCHMARK(multiply_add_peak)->Arg(1)->Arg(2)->ArgNames({"set"});
#endif

}  // namespace
