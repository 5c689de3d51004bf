#pragma once
/// The common tangents of four spheres by the two systems of Hoffmann, Yuan 2000, section 4.1, as they stand.
///
/// quadrics: their six equations in the point p of the line and its direction u, with the first centre as the origin
/// and c the others,
///   (1) p·p = r_1²,  (2)–(4) (c − p)·(c − p) − (c·u)² = r²,  (5) p·u = 0,  (6) u·u = 1,
/// of total degree 2⁶ = 64. At infinity they leave a curve, u = 0 and p·p = 0, to which paths lead.
///
/// cubic: (2)–(4) less (1) give p = C⁻¹ q(u), the rows of C the centres c, q = ½(c·c + r_1² − r² − (c·u)²); put into
/// (6), (5) and (1) that leaves equations of degrees 2, 3 and 4 in u, 24 paths. Coplanar centres have no C⁻¹.
///
/// Both are made homogeneous with h, with a random affine patch a·X = 1, and followed from X_k^d = h^d by a straight
/// line. An end with h = 0 is at infinity. Both directions of a line are solutions.

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

#include "solvers/tangents/tangent_ends.hpp"

namespace gcs {

enum class PublishedSystem { quadrics, cubic };

/// Why the system cannot be written down for these spheres, or nullopt.
std::optional<std::string> why_no_system(const FourSpheres& spheres, PublishedSystem system);

/// Follows all 64 or 24 paths. Reproducible from the seed. `found.at_infinity`: of the cubic system half of the paths
/// that end there; of the quadrics, whose paths to infinity are no lines as a rule, 0. `monitor` may be null.
/// Precondition: there is such a system; lengths are of order 1.
FollowedTangents follow_published_tangents(const FourSpheres& spheres, PublishedSystem system,
                                           std::uint64_t seed, const std::stop_token& stop, Monitor* monitor,
                                           WorkCounters& work);

}  // namespace gcs
