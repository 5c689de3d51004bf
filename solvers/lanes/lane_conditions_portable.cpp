/// Condition numbers in lanes for any machine.
#define GCS_LANES portable_lanes
#include "solvers/lanes/lane_conditions.hpp"

namespace gcs {

ConditionFunction portable_conditions() { return portable_lanes::conditions_of; }

}  // namespace gcs
