/// The tracker's lanes for any machine.
#define GCS_LANES portable_lanes
#include "solvers/lanes/lane_factories.hpp"

namespace gcs {

LaneTrackerFactories portable_lane_trackers() { return portable_lanes::factories(); }

}  // namespace gcs
