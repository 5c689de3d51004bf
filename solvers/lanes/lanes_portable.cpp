/// All that is made in lanes, for any machine.
#define GCS_LANES portable_lanes
#include "solvers/lanes/lane_columns.hpp"
#include "solvers/lanes/lane_conditions.hpp"
#include "solvers/lanes/lane_factories.hpp"
#include "solvers/lanes/lane_functions.hpp"

namespace gcs {

LaneFunctions portable_lane_functions() {
  return {portable_lanes::factories(), portable_lanes::conditions_of, portable_lanes::column_kernels()};
}

}  // namespace gcs
