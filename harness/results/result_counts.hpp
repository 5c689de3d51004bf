#pragma once
/// The counts of a solve as a result states them, with their convention.

#include "harness/base/record_fields.hpp"
#include "harness/solving/solve_run.hpp"

namespace gcs {

struct ResultCounts {
  std::optional<Convention> convention;
  std::optional<Natural> real;     ///< solutions by this convention, whichever it is
  std::optional<Natural> complex;  ///< likewise
  Counts counts;                   ///< those up to reflection empty where mirror images are two
};

/// What a result says of these counts.
ResultCounts stated_counts(const ProblemStatement& problem, const Counts& counts);

/// What a result that says this counts, by the convention of its problem.
Counts counts_of(const ResultCounts& stated);

/// As in record_json.hpp. A file may leave out the convention and what goes with it.
template <typename Record, typename Visit>
void visit_result_counts(Record& stated, Visit visit) {
  visit.named("convention", stated.convention, all_conventions);
  visit.later("real", stated.real);
  visit.later("complex", stated.complex);
  visit_counts(stated.counts, visit);
  visit.where_it_applies("not_as_stated", stated.counts.not_as_stated);
  visit.where_it_applies("undecided", stated.counts.undecided);
}

}  // namespace gcs
