/// The tracker's lanes for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx2_lanes
#include "solvers/lanes/lane_factories.hpp"

namespace gcs {

LaneTrackerFactories avx2_lane_trackers() { return avx2_lanes::factories(); }

}  // namespace gcs
