/// The tracker's lanes for any machine, and one lane of higher precision.
#define GCS_LANES portable_lanes
#include "solvers/lanes/lane_factories.hpp"

namespace gcs {

LaneTrackerFactories portable_lane_trackers() { return portable_lanes::factories<portable_lanes::Lanes>(); }

LaneTrackerFactories wide_lane_trackers() { return portable_lanes::factories<portable_lanes::Wide>(); }

}  // namespace gcs
