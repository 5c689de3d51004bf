#pragma once
/// A constraint's value replaced by another one.

#include <string>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Gives the constraint of that id another value in the form in which it has one: a length, its square, an angle in degrees
/// or its cosine. `number` is an exact decimal; `source` is for messages. Throws InputError for an id that no constraint
/// has, a constraint without a value, and values that it cannot have.
void change_value(ProblemStatement& problem, const std::string& id, const std::string& number,
                  const std::string& source);

}  // namespace gcs
