/// All that is made in lanes, for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx2_lanes
#include "solvers/lanes/lane_columns.hpp"
#include "solvers/lanes/lane_conditions.hpp"
#include "solvers/lanes/lane_factories.hpp"

namespace gcs {

LaneTrackerFactories avx2_lane_trackers() { return avx2_lanes::factories(); }
ConditionFunction avx2_conditions() { return avx2_lanes::conditions_of; }
ColumnKernels avx2_column_kernels() { return avx2_lanes::column_kernels(); }

}  // namespace gcs
