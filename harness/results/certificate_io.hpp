#pragma once
/// Writes gcsbench-certificate/1: what somebody else needs to prove an answer again (scripts/check-certificate).

#include <cstddef>

#include "harness/base/document_text.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {

/// Throws InputError unless the instance is of points, none with a given position, and distances between them.
void require_certifiable(const Instance& instance);

/// The certified solutions of an answer, piece by piece, and how many there can be. Returns how many it has; those that
/// it does not have take more than its greatest precision. Precondition: the instance is certifiable.
std::size_t write_certificate(const Instance& instance, const Scene& scene, const Answer& answer,
                              const TextSink& take);

}  // namespace gcs
