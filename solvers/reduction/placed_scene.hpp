#pragma once
/// A scene whose elements are placed one by one on its core.

#include <functional>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/reduction/element_order.hpp"

namespace gcs {

/// Solves a part as a scene of its own; nothing where it is not known how.
using PartSolver = std::function<std::optional<SolveReport>(const SolveRequest&)>;

/// A step that hangs on nothing but given positions, as a scene of its own; nothing where it hangs on something else.
std::optional<SubProblem> problem_of_step(const ElementOrder& order, const PlacingStep& step);

/// The report on the whole: of the core, unless it is given, and of each step that is a scene of its own, `solve` makes
/// one, the core's first; the other steps are solved by paths (step_solver.hpp), for all complex solutions. At most
/// `most_listed` solutions are candidates; the totals count all, unless a solution of the core is its own mirror image.
SolveReport solve_placed(const SolveRequest& request, const ElementOrder& order, const PartSolver& solve,
                         std::size_t most_listed);

}  // namespace gcs
