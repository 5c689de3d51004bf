#pragma once
/// Whether two reports on one scene can both be right.

#include <optional>
#include <string>

#include "solvers/interface/strategy_interface.hpp"

namespace gcs::contract {

/// Two solutions of different classes that are closer than this, relative to the scene's size, do not occur
/// in the instances tested; the same solution computed twice differs by the rounding of its coordinates times
/// its condition number, at most about 1e4 there.
inline constexpr double agreement_tolerance = 1e-9;

/// A sentence that says where the reports contradict each other, or nothing. Only complete reports are
/// compared, by reflection classes. Two exhaustive claims hold the same classes; a claim that is not
/// exhaustive holds no class that an exhaustive one lacks; two claims to the solutions on S hold the same
/// ones in the same cyclic order and directions, or in exactly the reversed ones. Precondition: one path in a
/// report that claims S.
std::optional<std::string> contradiction(const Scene& scene, const SolveReport& a, const SolveReport& b);

/// A sentence that names a candidate of `part` whose class `whole` does not hold, or nothing.
std::optional<std::string> outsider(const Scene& scene, const SolveReport& part, const SolveReport& whole);

}  // namespace gcs::contract
