#pragma once
/// From the ends of paths to solutions of a general scene, with what they prove or leave open.

#include <random>
#include <vector>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/general_family.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// As complex_report: candidates from the finite ends, distinct up to signs and real where Newton's method on the real
/// part agrees; a record for every path. Solutions that doubles hardly tell apart are proven with the file's own numbers,
/// and named where they are not.
SolveReport general_report(const SceneSystem& scene, const GeneralEquations& equations,
                           const std::vector<PathEnd>& ends, const WorkCounters& work,
                           std::mt19937_64& random);

}  // namespace gcs
