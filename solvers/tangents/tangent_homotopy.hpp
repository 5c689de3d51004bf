#pragma once
/// The common tangents of four spheres by following 24 paths, one for each line and orientation.
///
/// The target is (a·u)² = 1, a random complex vector, with the three equations of tangent_equations.hpp:
/// degrees 2, 2, 3 and 4 in unknowns of weight 1 (u) and 2 (τ), so 2·2·3·4/2 = 24 solutions, two for each
/// line. Where the centres are not coplanar τ = κ/h makes it the published system of degrees 2, 3 and 4 in u
/// (Hoffmann, Yuan 2000, section 4.1), but for the normalisation: u·u = 1 there sends isotropic directions to
/// infinity and distant lines near to it, a random one leaves all solutions at finite places. Start: x² = 1,
/// τ = y², g³ = 1, τ² = 1, whose 24 solutions are known.

#include <cstdint>
#include <random>
#include <stop_token>
#include <vector>

#include "solvers/strategy.hpp"
#include "solvers/tangents/found_tangents.hpp"
#include "solvers/tracking/path_tracker.hpp"

namespace gcs {

class TangentHomotopy {
 public:
  static constexpr int unknowns = 4;  ///< x, y, g, τ

  /// a and γ are random.
  TangentHomotopy(const TangentEquations& equations, std::mt19937_64& random);

  HomotopyValue<unknowns> at(const ComplexVector<unknowns>& x, std::complex<double> t) const;
  /// The 24 zeros at t = 0.
  static std::vector<ComplexVector<unknowns>> starts();

 private:
  SystemValue<unknowns> target(const ComplexVector<unknowns>& x) const;

  const TangentEquations& equations_;
  std::complex<double> gamma_;
  Eigen::Vector3cd patch_;              ///< a
  double scale_1_, scale_2_, scale_3_;  ///< bring the equations to the size 1
};

struct FollowedTangents {
  CommonTangents found;
  std::vector<PathRecord> paths;  ///< one for each start; `stopped` those that a stop left out
};

/// Follows all paths and polishes the lines where they end like common_tangents: a regular end is a simple
/// line, however many paths end there; the multiplicity of a singular one is half the number of its paths.
/// Reproducible from the seed. Preconditions as for common_tangents. `monitor` may be null.
FollowedTangents follow_tangents(const FourSpheres& spheres, std::uint64_t seed, const std::stop_token& stop,
                                 Monitor* monitor, WorkCounters& work);

}  // namespace gcs
