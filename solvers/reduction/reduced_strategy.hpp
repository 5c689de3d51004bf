#pragma once
/// What a scene does not need is left out, for every strategy in the same way: points that can be placed
/// after all others are placed after them; a scene that d points at given distances separate is solved side
/// by side; the solutions are put together. Option `reduce`.
///
/// Strategies that claim all solutions solve every part, and their solutions are multiplied
/// (solution_product.hpp). A path strategy follows the path of what is left without hung points
/// (core_path.hpp), which is another curve than that of the whole scene; so it does this only when asked to.

#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// The entry with the option `reduce`: off by default for strategies that need a sketch, else on.
StrategyEntry with_reduction(StrategyEntry inner);

}  // namespace gcs
