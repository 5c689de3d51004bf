#pragma once
/// Writes gcsbench-certificate/1: what somebody else needs to prove an answer again (scripts/check-certificate).

#include <cstddef>

#include "harness/base/document_text.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {

/// Throws InputError unless the instance is of points, lines and planes with distances from points, and cosines between
/// planes, in a frame of points, of a line and a point, or of points with given positions that leave no motion.
void require_certifiable(const Instance& instance);

/// The certified solutions of an answer, piece by piece, and how many there can be. Returns how many it has; those that
/// it does not have take more than its greatest precision. Precondition: the instance is certifiable.
std::size_t write_certificate(const Instance& instance, const Scene& scene, const Answer& answer,
                              const TextSink& take);

}  // namespace gcs
