#pragma once
/// Writes a problem as an instance file, so that `gcsbench solve` can be asked about it.

#include <string>

#include "solvers/model/problem.hpp"

namespace gcs {

/// The text of gcsbench-instance/1, every number exact. Precondition: points only, with a sketch.
std::string instance_text(const ProblemStatement& problem, const std::string& id);

}  // namespace gcs
