#include "solvers/lanes/lane_trackers.hpp"

#include <cmath>

namespace gcs {
namespace {

LaneTrackerFactories factories_of(InstructionSet set) {
#ifdef GCS_X86
  if (set == InstructionSet::avx512) return avx512_lane_trackers();
  if (set == InstructionSet::avx2) return avx2_lane_trackers();
#endif
  return portable_lane_trackers();
}

}  // namespace

ComplexVectorX parameters_at(const Route& route, double s) {
  ComplexVectorX parameters(route.end.size());
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    for (int k = Route::degree; k >= 0; --k) parameters[j] = parameters[j] * s + route.coefficients[k][j];
    if (!route.rates.empty()) parameters[j] *= std::exp(route.rates[j] * (s - 1));
  }
  return parameters;
}

std::string_view name(InstructionSet set) {
  switch (set) {
    case InstructionSet::portable:
      return "portable";
    case InstructionSet::avx2:
      return "AVX2";
    case InstructionSet::avx512:
      return "AVX-512";
  }
  return "";
}

bool is_available(InstructionSet set) {
  if (set == InstructionSet::portable) return true;
#ifdef GCS_X86
  if (set == InstructionSet::avx512) return __builtin_cpu_supports("avx512f") != 0;
  return __builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0;
#else
  return false;
#endif
}

InstructionSet widest_instruction_set() {
  if (is_available(InstructionSet::avx512)) return InstructionSet::avx512;
  return is_available(InstructionSet::avx2) ? InstructionSet::avx2 : InstructionSet::portable;
}

std::unique_ptr<LaneTracker> make_lane_tracker(InstructionSet set, const SquareSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options) {
  return factories_of(set).for_squares(system, elimination, options);
}

std::unique_ptr<LaneTracker> make_lane_tracker(InstructionSet set, const MonomialSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options) {
  return factories_of(set).for_monomials(system, elimination, options);
}

std::unique_ptr<LaneTracker> make_wide_tracker(InstructionSet set, const SquareSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options) {
  return factories_of(set).wide_for_squares(system, elimination, options);
}

std::unique_ptr<LaneTracker> make_wide_tracker(InstructionSet set, const MonomialSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options) {
  return factories_of(set).wide_for_monomials(system, elimination, options);
}

}  // namespace gcs
