#pragma once
/// The numbers of a scene's file, exactly, in the scene's unit, which is a power of two of the file's.

#include <optional>

#include "solvers/model/quadratic_system.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/numeric/double_double.hpp"
#include "solvers/numeric/exact_number.hpp"
#include "solvers/numeric/rational.hpp"

namespace gcs {

/// The squared length of a constraint.
ExactNumber given_square(const Scene& scene, int constraint);

/// A length that the file gives, whatever its sign. Precondition: decimals that are not 0 do not round to it.
ExactNumber given_length(const Scene& scene, const Decimal& given);

/// The cosine that a relation gives, its square where `is_squared`.
ExactNumber given_cosine(const Relation& relation, bool is_squared);

/// Coordinate `axis` of a point; 0 where the file gives none.
ExactNumber given_coordinate(const Scene& scene, int point, int axis);

/// The real part. Preconditions: it is no cosine of degrees, and divided by nothing.
Rational rational(const ExactNumber& number);

/// Of any real number; nothing where it is divided by a root that is no fraction, or is a cosine of degrees.
std::optional<Rational> fraction(const ExactNumber& number);
/// Of all coefficients, and what is given.
bool has_fractions(const QuadraticEquation& equation);

/// The real part in double-double: right to 2^-104 relative, or to what underflows.
DoubleDouble nearest_double_double(const ExactNumber& number);

/// At least how far the double of a given coordinate is from the file's decimal.
double coordinate_error(const Scene& scene, int point, int axis);

}  // namespace gcs
