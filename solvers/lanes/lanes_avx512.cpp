/// All that is made in lanes, for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx512_lanes
#include "solvers/lanes/lane_columns.hpp"
#include "solvers/lanes/lane_conditions.hpp"
#include "solvers/lanes/lane_factories.hpp"
#include "solvers/lanes/lane_functions.hpp"

namespace gcs {

LaneFunctions avx512_lane_functions() {
  return {avx512_lanes::factories(), avx512_lanes::conditions_of, avx512_lanes::column_kernels()};
}

}  // namespace gcs
