#pragma once
/// The equations of a general scene multiplied out, with the exact numbers of the file.

#include <optional>
#include <string>

#include "solvers/model/quadratic_system.hpp"
#include "solvers/systems/polynomial_system.hpp"

namespace gcs {

/// Why equations are no polynomials with rational coefficients of few unknowns, in a sentence; nothing where they are.
std::optional<std::string> why_no_polynomials(const QuadraticSystem& system);

/// Precondition: !why_no_polynomials(system).
PolynomialSystem polynomials_of(const QuadraticSystem& system);

}  // namespace gcs
