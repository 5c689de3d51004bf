#pragma once
/// The trackers of one instruction set, for both kinds of systems and both precisions.

#include "solvers/lanes/lane_functions.hpp"
#include "solvers/lanes/lane_kernel.hpp"
#include "solvers/lanes/monomial_lanes.hpp"
#include "solvers/lanes/square_lanes.hpp"

namespace gcs::GCS_LANES {

template <class Equations>
std::unique_ptr<LaneTracker> make(const typename Equations::System& system, const Elimination& elimination,
                                  const TrackingOptions& options) {
  return std::make_unique<KernelTracker<Equations>>(system, elimination, options);
}

inline LaneTrackerFactories factories() {
  return {make<SquareEquations<Lanes>>, make<MonomialEquations<Lanes>>, make<SquareEquations<Wide>>,
          make<MonomialEquations<Wide>>};
}

}  // namespace gcs::GCS_LANES
