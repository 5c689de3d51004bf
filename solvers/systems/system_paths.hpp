#pragma once
/// All isolated zeros of a polynomial system by paths, and how each path ends.
///
/// mixed_cells: as many paths as the mixed volume, from the mixed cells of its monomials to a system of the same
/// monomials with random coefficients (polyhedral/polyhedral_homotopies.hpp), and on to the system by one homotopy in the
/// coefficients. total_degree: as many as Bézout's number, from x_i^(d_i) = 1, each times a random number of modulus 1,
/// by a straight line to the system: the way of C. Durand 1998 and before. Both go through the system's quadratic lift.
/// Step control is a heuristic: where two paths end at one regular zero a step has jumped, and `jumps` says so.

#include <functional>
#include <stop_token>
#include <string_view>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/numeric/natural.hpp"
#include "solvers/systems/polynomial_system.hpp"

namespace gcs {

enum class PathStart { mixed_cells, total_degree };

struct SystemPathsRequest {
  const PolynomialSystem& system;
  PathStart start = PathStart::mixed_cells;
  TrackingSetup setup;
  std::uint64_t seed = 1;
  std::stop_token stop;
  std::function<void(std::string_view stage, double fraction)> progress;
};

struct FollowedSystem {
  /// One for each path, x in the unknowns of the system. What was lost before the last homotopy is `failed`.
  std::vector<PathEnd> ends;
  int jumps = 0;         ///< regular ends at which another path had ended
  std::string why_none;  ///< no paths could be started
  bool is_stopped = false;
};

/// The mixed volume, by which generic coefficients have so many zeros without a zero coordinate; nothing where the
/// cells cannot be enumerated, or on a stop.
std::optional<Natural> mixed_volume(const Supports& supports, std::uint64_t seed, int threads,
                                    const std::stop_token& stop);

/// Adds to `work`. Preconditions: no equation is 0; total_degree: there are 2²⁰ paths at most, no degree is above 4.
FollowedSystem follow_system_paths(const SystemPathsRequest& request, WorkCounters& work);

}  // namespace gcs
