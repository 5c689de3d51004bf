/// Condition numbers in lanes for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx512_lanes
#include "solvers/lanes/lane_conditions.hpp"

namespace gcs {

ConditionFunction avx512_conditions() { return avx512_lanes::conditions_of; }

}  // namespace gcs
