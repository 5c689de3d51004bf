#pragma once
/// Several lines, each sought by its distances from given points: no line depends on another, and the solutions are all
/// combinations of theirs.

#include <vector>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// One problem for each line, with all points; none unless there are several lines, nothing but lines is sought, and
/// every line has four distances.
std::vector<ProblemStatement> problems_of_lines(const ProblemStatement& problem);

/// The report on the whole scene from those on its lines, in their order. At most `most_listed` solutions are candidates;
/// the totals count all.
SolveReport product_of_lines(const Scene& whole, const std::vector<Scene>& lines,
                             std::vector<SolveReport> reports, std::size_t most_listed);

}  // namespace gcs
