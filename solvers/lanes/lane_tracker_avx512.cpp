/// The tracker's lanes for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx512_lanes
#include "solvers/lanes/lane_factories.hpp"

namespace gcs {

LaneTrackerFactories avx512_lane_trackers() { return avx512_lanes::factories(); }

}  // namespace gcs
