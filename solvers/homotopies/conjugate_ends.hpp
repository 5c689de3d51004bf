#pragma once
/// Ends of paths that were lost, where conjugates say where they are.

#include <functional>
#include <random>
#include <vector>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/numeric/sign_masks.hpp"

namespace gcs {

/// Of equations with real coefficients the conjugate of a regular zero is one, and where the starts are all zeros at random
/// parameters, some path ends there (Morgan, Sommese 1989). If the conjugates of regular ends are missing among the ends,
/// and no more of them than paths have failed, failed paths are what ends there: each is given one as its end.
/// `jacobian_at`: unknowns² entries, of the equations at a zero. `signs`: changes of signs that are divided out.
void end_at_conjugates(const std::function<ComplexVectorX(const ComplexVectorX&)>& jacobian_at,
                       const SignMasks& signs, std::mt19937_64& random, std::vector<PathEnd>& ends);

}  // namespace gcs
