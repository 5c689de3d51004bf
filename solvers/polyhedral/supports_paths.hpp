#pragma once
/// All zeros of sparse equations from the mixed cells of their monomials: zeros for random coefficients
/// (polyhedral_homotopies.hpp), then one homotopy in the coefficients.

#include <functional>
#include <random>
#include <stop_token>
#include <string>
#include <string_view>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/numeric/natural.hpp"
#include "solvers/numeric/sign_masks.hpp"
#include "solvers/polyhedral/supports.hpp"

namespace gcs {

/// How the paths are followed, and who hears of it.
struct SupportsRequest {
  TrackingSetup setup;
  std::uint64_t seed = 0;
  std::stop_token stop;
  std::function<void(std::string_view stage, double fraction)> progress;
  std::string destination;  ///< what the coefficients are of, in words
};

struct PathCounts {
  Natural mixed_volume;
  std::int64_t cells = 0;
  std::int64_t start_paths = 0;  ///< where mirror images are divided out, one of each set of them
  std::int64_t at_infinity = 0;  ///< of these, where they led to no zero
};

struct SupportsPaths {
  std::vector<PathEnd> ends;  ///< of the paths to the coefficients
  std::string missing;        ///< what may keep them from being all; empty when nothing does
  PathCounts counts;
  bool is_stopped = false;
};

/// `coefficients`: one per monomial, equation by equation. `signs`: as for follow_polyhedral_homotopies. Adds to `work`.
/// Precondition: as for monomial_system.
SupportsPaths follow_supports(const Supports& supports, const ComplexVectorX& coefficients,
                              const SignMasks& signs, const SupportsRequest& request, std::mt19937_64& random,
                              WorkCounters& work);

/// Why the ends at coefficients whose zeros are regular are not all zeros; empty where they are. `distinct`: how many
/// regular ends are.
std::string why_not_all(const std::vector<PathEnd>& ends, int distinct, const std::string& destination);

}  // namespace gcs
