/// All that is made in lanes, for any machine.
#define GCS_LANES portable_lanes
#include "solvers/lanes/lane_columns.hpp"
#include "solvers/lanes/lane_conditions.hpp"
#include "solvers/lanes/lane_factories.hpp"

namespace gcs {

LaneTrackerFactories portable_lane_trackers() { return portable_lanes::factories(); }
ConditionFunction portable_conditions() { return portable_lanes::conditions_of; }
ColumnKernels portable_column_kernels() { return portable_lanes::column_kernels(); }

}  // namespace gcs
