#include "solvers/elements/constraint_types.hpp"

namespace gcs {

/// Of one point more than the dimension. It selects real solutions, and is no equation.
ConstraintType orientation_type() {
  return {"orientation", ConstraintType::Value::sign, {{{}, state_nothing}}};
}

}  // namespace gcs
