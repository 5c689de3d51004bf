/// All that is made in lanes, for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx512_lanes
#include "solvers/lanes/lane_columns.hpp"
#include "solvers/lanes/lane_conditions.hpp"
#include "solvers/lanes/lane_factories.hpp"

namespace gcs {

LaneTrackerFactories avx512_lane_trackers() { return avx512_lanes::factories(); }
ConditionFunction avx512_conditions() { return avx512_lanes::conditions_of; }
ColumnKernels avx512_column_kernels() { return avx512_lanes::column_kernels(); }

}  // namespace gcs
