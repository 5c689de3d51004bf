#pragma once
/// The trackers of one kind of lanes, for both kinds of systems.

#include "solvers/lanes/lane_kernel.hpp"
#include "solvers/lanes/lane_trackers.hpp"
#include "solvers/lanes/monomial_lanes.hpp"
#include "solvers/lanes/square_lanes.hpp"

namespace gcs::GCS_LANES {

template <class Equations>
std::unique_ptr<LaneTracker> make(const typename Equations::System& system, const Elimination& elimination,
                                  const TrackingOptions& options) {
  return std::make_unique<KernelTracker<Equations>>(system, elimination, options);
}

template <class Real>
LaneTrackerFactories factories() {
  return {make<SquareEquations<Real>>, make<MonomialEquations<Real>>};
}

}  // namespace gcs::GCS_LANES
