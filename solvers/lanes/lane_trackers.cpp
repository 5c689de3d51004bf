#include "solvers/lanes/lane_trackers.hpp"

#include <cmath>

#include "solvers/lanes/lane_functions.hpp"

namespace gcs {

ComplexVectorX parameters_at(const Route& route, double s) {
  ComplexVectorX parameters(route.end.size());
  for (std::size_t j = 0; j < parameters.size(); ++j) {
    for (int k = Route::degree; k >= 0; --k) parameters[j] = parameters[j] * s + route.coefficients[k][j];
    if (!route.rates.empty()) parameters[j] *= std::exp(route.rates[j] * (s - 1));
  }
  return parameters;
}

std::unique_ptr<LaneTracker> make_lane_tracker(InstructionSet set, const SquareSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options) {
  return lane_functions(set).trackers.for_squares(system, elimination, options);
}

std::unique_ptr<LaneTracker> make_lane_tracker(InstructionSet set, const MonomialSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options) {
  return lane_functions(set).trackers.for_monomials(system, elimination, options);
}

std::unique_ptr<LaneTracker> make_wide_tracker(InstructionSet set, const SquareSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options) {
  return lane_functions(set).trackers.wide_for_squares(system, elimination, options);
}

std::unique_ptr<LaneTracker> make_wide_tracker(InstructionSet set, const MonomialSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options) {
  return lane_functions(set).trackers.wide_for_monomials(system, elimination, options);
}

}  // namespace gcs
