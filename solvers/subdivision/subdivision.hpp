#pragma once
/// Branch and prune: all real solutions of a system of quadratic equations in a box, by bisection, with proof.
///
/// A box is narrowed to what its equations and their linear relaxation leave; Krawczyk's operator may prove
/// that it holds no solution or, in a box around it, exactly one; else it is halved where
/// its equations are farthest from linear. What
/// becomes too small to be halved is undecided: a solution there is multiple, or nearly so.

#include <cstdint>
#include <stop_token>
#include <vector>

#include "solvers/certificates/krawczyk_test.hpp"
#include "solvers/running/work.hpp"

namespace gcs {

/// What narrows a box before it is halved: nothing but Krawczyk's operator; each equation alone as well; or
/// the linear relaxation of all of them too.
enum class Reduction { none, box, linear };

struct SubdivisionCounters {
  std::int64_t boxes = 0;
  std::int64_t bisections = 0;
  std::int64_t krawczyk_tests = 0;
  std::int64_t linear_programs = 0;
  std::int64_t pivots = 0;
  std::int64_t newton_iterations = 0;
};

struct SubdivisionOutcome {
  enum class End { complete, too_many_boxes, too_many_undecided, stopped };
  End end = End::complete;
  std::vector<ProvenSolution> solutions;  ///< in the box, or within rounding beside it; some may be the same
  std::vector<Box> undecided;             ///< as small as boxes become
  std::int64_t left = 0;                  ///< boxes that were not looked at
  SubdivisionCounters work;
};

struct SubdivisionMeans {
  Reduction reduction = Reduction::linear;
  std::int64_t max_boxes = 0;
  int threads = 1;
  std::stop_token stop{};
  Monitor* monitor = nullptr;
};

/// The same for any number of threads. Precondition: the box is finite, its unknowns of order `size`, and
/// there are as many equations as unknowns.
SubdivisionOutcome subdivide(const IntervalEquations& system, const IntervalBox& box, double size,
                             const SubdivisionMeans& means);

}  // namespace gcs
