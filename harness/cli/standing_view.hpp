#pragma once
/// How many real solutions of the equations the signs leave out that constraints state, as text.

#include <string>

#include "solvers/answers/assess.hpp"

namespace gcs {

/// A row for those that are not as stated and one for those of which it is undecided, where there are any, with how many are
/// against which constraint.
std::string standings_text(const ProblemStatement& problem, const Assessment& assessment);

}  // namespace gcs
