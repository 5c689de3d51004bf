#pragma once
/// Proven solutions in decimals, as references and results have them.

#include "solvers/certificates/decimal_figure.hpp"
#include "solvers/problem/problem_statement.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

/// The members "points", "lines" and, where there are any, "planes", with a text for each number and two for a complex one;
/// "error_bound", "unique_within" and "bits".
JsonMembers decimal_members(const ProblemStatement& problem, const DecimalFigure& figure, bool is_real);

}  // namespace gcs
