#pragma once
/// The members of counts, counters and environments by the names that files use. Whatever reads or writes one
/// visits it through these lists, so that no two files disagree. `visit(name, member)`.

namespace gcs {

template <typename Record, typename Visit>
void visit_counts(Record& counts, Visit visit) {
  visit("real_up_to_reflection", counts.real_up_to_reflection);
  visit("complex_up_to_reflection", counts.complex_up_to_reflection);
  visit("generic", counts.generic);
  visit("on_path", counts.on_path);
  visit("paths", counts.paths);
  visit("at_infinity", counts.at_infinity);
  visit("singular", counts.singular);
  visit("failed_paths", counts.failed_paths);
  visit("certified", counts.certified);
}

template <typename Record, typename Visit>
void visit_totals(Record& totals, Visit visit) {
  visit("real", totals.real);
  visit("complex", totals.complex);
  visit("generic", totals.generic);
}

template <typename Record, typename Visit>
void visit_work(Record& work, Visit visit) {
  visit("iterations", work.iterations);
  visit("rejected_steps", work.rejected_steps);
  visit("newton_iterations", work.newton_iterations);
  visit("evaluations", work.evaluations);
  visit("partial_evaluations", work.partial_evaluations);
  visit("jacobians", work.jacobians);
  visit("factorisations", work.factorisations);
  visit("plan_changes", work.plan_changes);
  visit("smallest_step", work.smallest_step);
  visit("mean_driving_parameters", work.mean_driving_parameters);
  visit("max_driving_parameters", work.max_driving_parameters);
}

/// The counts that only the strategy knows, by the names that it gives them.
template <typename Particulars, typename Visit>
void visit_particulars(Particulars& particulars, Visit visit) {
  for (auto& particular : particulars) visit(particular.name, particular.value);
}

template <typename Record, typename Visit>
void visit_environment(Record& environment, Visit visit) {
  visit("cpu", environment.cpu);
  visit("compiler", environment.compiler);
  visit("flags", environment.flags);
  visit("commit", environment.commit);
  visit("threads", environment.threads);
  visit("instructions", environment.instructions);
}

}  // namespace gcs
