#pragma once
/// Writes gcsbench-certificate/2: what somebody else needs to prove an answer again (scripts/check-certificate).

#include <cstdint>

#include "harness/base/document_text.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {

/// Throws InputError unless the instance's frame begins at a point, has a line and a point, is a body, or given by elements of
/// no body with positions that leave no motion.
void require_certifiable(const Instance& instance);

/// The certified solutions of an answer, and clusters, piece by piece, and how many there can be. Returns how many it has,
/// with multiplicities; those that it does not have take more than its greatest precision. Precondition: the instance is certifiable.
std::uint64_t write_certificate(const Instance& instance, const Scene& scene, const Answer& answer,
                                const TextSink& take);

}  // namespace gcs
