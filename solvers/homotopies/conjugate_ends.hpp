#pragma once
/// Ends of paths that were lost, where conjugates say where they are.

#include <cstddef>
#include <functional>
#include <random>
#include <vector>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/numeric/sign_masks.hpp"

namespace gcs {

/// A path that failed, among others.
struct LostPath {
  std::size_t number = 0;
  PathEnd end;
};

/// Of equations with real coefficients the conjugate of a regular zero is one, and where the starts are all zeros at random
/// parameters, some path ends there (Morgan, Sommese 1989). If the conjugates of regular ends are missing among the ends,
/// and no more of them than paths have failed, failed paths are what ends there: each is given one as its end.
/// `is_isolated`: whether a zero that is not real is known to be a regular one. `signs`: changes of signs that are divided out.
/// Returns those as they failed: which of them ends at which place is not known, so that no path is to be followed again from
/// there.
std::vector<LostPath> end_at_conjugates(const std::function<bool(const ComplexVectorX&)>& is_isolated,
                                        const SignMasks& signs, std::mt19937_64& random,
                                        std::vector<PathEnd>& ends);

/// Of unknowns² entries, by the reciprocal condition number: zeros on curves, whose conjugates prove nothing, lose rank to
/// some 1e-13.
bool keeps_rank(const ComplexVectorX& jacobian);

/// The inverse.
void restore(std::vector<LostPath> lost, std::vector<PathEnd>& ends);

}  // namespace gcs
