#include "solvers/running/work.hpp"

#include <algorithm>

namespace gcs {

void add(const WorkCounters& more, WorkCounters& work) {
  for (const auto member :
       {&WorkCounters::iterations, &WorkCounters::rejected_steps, &WorkCounters::newton_iterations,
        &WorkCounters::evaluations, &WorkCounters::partial_evaluations, &WorkCounters::jacobians,
        &WorkCounters::factorisations, &WorkCounters::plan_changes})
    work.*member += more.*member;
  if (more.smallest_step)
    work.smallest_step = std::min(*more.smallest_step, work.smallest_step.value_or(*more.smallest_step));
}

}  // namespace gcs
