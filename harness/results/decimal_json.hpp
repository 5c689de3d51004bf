#pragma once
/// Proven solutions in decimals, as references and results have them.

#include "solvers/certificates/decimal_figure.hpp"
#include "solvers/problem/problem_statement.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

/// A text, of a complex number two.
JsonValue json_decimal(const DecimalNumber& number, bool is_real);
/// The first `dimension` coordinates.
JsonValue json_decimals(const DecimalVector& vector, int dimension, bool is_real);

/// The members "points", "lines" and, where there are any, "planes"; "error_bound", "unique_within" and "bits".
JsonMembers decimal_members(const ProblemStatement& problem, const DecimalFigure& figure, bool is_real);

}  // namespace gcs
