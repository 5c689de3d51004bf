#pragma once
/// Which function makes the trackers of which lanes; each is compiled for its own instruction set.

#include "solvers/complex_tracking/lane_tracker.hpp"

namespace gcs {

template <class System>
using LaneTrackerFactory = std::unique_ptr<LaneTracker> (*)(const System&, const Elimination&,
                                                            const TrackingOptions&);

struct LaneTrackerFactories {
  LaneTrackerFactory<SquareSystem> for_squares;
  LaneTrackerFactory<MonomialSystem> for_monomials;
};

LaneTrackerFactories portable_lane_trackers();
LaneTrackerFactories wide_lane_trackers();
#ifdef GCS_X86
LaneTrackerFactories avx2_lane_trackers();
LaneTrackerFactories avx512_lane_trackers();
#endif

}  // namespace gcs
