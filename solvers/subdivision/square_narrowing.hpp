#pragma once
/// What each equation alone says of a box: hull consistency (Benhamou, Goualard, Granvilliers, Puget, Revising
/// hull and box consistency, 1999). Each product of Σ left·right = given lies in given − Σ the others, each
/// form in what its product and its other form allow, and each unknown in what its form and the other unknowns
/// allow. An unknown occurs once in the equation of a distance, where this is box consistency.

#include <optional>
#include <vector>

#include "solvers/certificates/interval_equations.hpp"

namespace gcs {

/// Narrows the box until a pass over all equations leaves most of it. Returns an interval for every form, which
/// holds its values at all solutions in the box; nothing where the box is proven to hold no solution.
std::optional<std::vector<Interval>> narrow_by_equations(const IntervalEquations& system, IntervalBox& box);

/// The values of every form on the box.
std::vector<Interval> forms_over(const IntervalEquations& system, const IntervalBox& box);

/// Whether some equation cannot hold where the forms have values in these intervals.
bool are_contradictory(const IntervalEquations& system, const std::vector<Interval>& forms);

}  // namespace gcs
