#include "harness/results/result_counts.hpp"

namespace gcs {

ResultCounts stated_counts(const ProblemStatement& problem, const Counts& counts) {
  ResultCounts stated{convention_of(problem), counts.real_up_to_reflection, counts.complex_up_to_reflection,
                      counts};
  if (stated.convention == Convention::up_to_motion) {
    stated.counts.real_up_to_reflection.reset();
    stated.counts.complex_up_to_reflection.reset();
  }
  return stated;
}

Counts counts_of(const ResultCounts& stated) {
  Counts counts = stated.counts;
  if (stated.real) counts.real_up_to_reflection = stated.real;
  if (stated.complex) counts.complex_up_to_reflection = stated.complex;
  return counts;
}

}  // namespace gcs
