/// Condition numbers in lanes for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx2_lanes
#include "solvers/lanes/lane_conditions.hpp"

namespace gcs {

ConditionFunction avx2_conditions() { return avx2_lanes::conditions_of; }

}  // namespace gcs
