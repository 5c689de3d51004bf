#pragma once
/// All solutions in a small box, where they are too close together for Krawczyk's test on all of it.
///
/// Near a singular or nearly singular solution the equations determine all directions but few: what may hold
/// a solution is thin and long. The box is therefore enclosed in one along the right singular vectors of the
/// Jacobian, and that one is narrowed by Krawczyk's operator and halved where it is longest, until every part
/// is proven to hold no solution or one.

#include <optional>
#include <vector>

#include "solvers/certificates/krawczyk.hpp"
#include "solvers/certificates/krawczyk_test.hpp"

namespace gcs {

/// Boxes around the solutions in `box`, each with exactly one solution, which may lie twice in the list and
/// outside of `box` by less than the boxes are wide. Nothing where more than `most_parts` parts do not decide
/// it. `squares` are as in `krawczyk`, to which the proof goes back.
std::optional<std::vector<Box>> solutions_in(const DistanceSystem& system,
                                             const std::vector<DoubleDouble>& squares, const Box& box,
                                             int most_parts);

/// The same of a quadratic system, by its test.
std::optional<std::vector<Box>> solutions_in(const KrawczykTest& test, const Box& box, int most_parts);

}  // namespace gcs
