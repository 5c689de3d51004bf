/// All that is made in lanes, for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx2_lanes
#include "solvers/lanes/lane_columns.hpp"
#include "solvers/lanes/lane_conditions.hpp"
#include "solvers/lanes/lane_factories.hpp"
#include "solvers/lanes/lane_functions.hpp"

namespace gcs {

LaneFunctions avx2_lane_functions() {
  return {avx2_lanes::factories(), avx2_lanes::conditions_of, avx2_lanes::column_kernels()};
}

}  // namespace gcs
