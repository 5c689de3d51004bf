#pragma once
/// Where a point of a proven solution is, for its coordinates.

#include "solvers/certificates/enclosure.hpp"
#include "solvers/elements/element_forms.hpp"
#include "solvers/elements/stated_signs.hpp"

namespace gcs {

/// The values that the forms of a point take at a real solution whose unknowns lie in the enclosure; the forms' numbers
/// count as exact.
EnclosedPoint enclosed_point(const VectorForm& point, const Enclosure& enclosure);

}  // namespace gcs
