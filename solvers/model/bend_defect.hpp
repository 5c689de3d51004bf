#pragma once
/// [I] Definition 1 asks of an interpolation that every length is positive for t from 0 to 1. It is proven for the
/// exact decimals: there a_i(t) grows with each of its parameters, so that a proof for lower bounds is one.

#include <optional>
#include <string>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

struct BendDefect {
  std::string what;    ///< one sentence: what is wrong
  std::string remedy;  ///< one sentence: what would be right
};

/// Why a length may not be bent so: too many coefficients, one that is no finite number, or a length that is not
/// proven to be positive on the way from the sketch, where there is one, to the target. Precondition: bent.constraint
/// is one of the constraints.
std::optional<BendDefect> bend_defect(const ProblemStatement& problem, const BentLength& bent);

}  // namespace gcs
