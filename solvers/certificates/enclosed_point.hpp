#pragma once
/// Where a point of a proven solution is, for its coordinates.

#include "solvers/elements/element_forms.hpp"
#include "solvers/elements/stated_signs.hpp"
#include "solvers/model/enclosure.hpp"
#include "solvers/numeric/balls.hpp"

namespace gcs {

/// A ball for every unknown.
BallMatrix balls_of(const Enclosure& enclosure);

/// Encloses the values of a form where each unknown is in its ball.
void enclose(acb_ptr sum, const LinearForm& form, const BallMatrix& unknowns, slong bits);

/// The values that the forms of a point take at a real solution whose unknowns lie in the enclosure; the forms' numbers
/// count as exact.
EnclosedPoint enclosed_point(const VectorForm& point, const Enclosure& enclosure);

}  // namespace gcs
