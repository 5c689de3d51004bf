#pragma once
/// A scene that is solved in steps.

#include <functional>
#include <optional>

#include "solvers/elements/element_order.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Solves a step that is a scene of its own; nothing where it is not known how.
using PartSolver = std::function<std::optional<SolveReport>(const PlacingStep&, const SolveRequest&)>;

/// The report on the whole: of each step that is a scene of its own `solve` makes one, in their order, and does so of
/// cores; the other steps are solved by paths (step_solver.hpp), for all complex solutions. At most `most_listed`
/// solutions are candidates; the totals count all, unless a solution of a core is its own mirror image.
///
/// Nothing where a step has no way at random numbers, as where an unknown of it is 0 whatever they are: its equations are
/// too special for paths of its own.
std::optional<SolveReport> solve_placed(const SolveRequest& request, const ElementOrder& order,
                                        const PartSolver& solve, std::size_t most_listed);

}  // namespace gcs
