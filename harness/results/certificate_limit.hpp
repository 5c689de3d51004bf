#pragma once
/// How many solutions a scene has at most, as a certificate says it.

#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {

/// Their names, as a list.
JsonValue names_value(const ProblemStatement& problem, const std::vector<int>& entities);

/// The member `limit` of gcsbench-certificate/1: parts that are placed one after another, or null where one of them has no
/// limit. Precondition: the scene's instance is certifiable.
JsonValue certificate_limit(const Scene& scene);

}  // namespace gcs
