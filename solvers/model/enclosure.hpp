#pragma once
/// Where a proof says that a solution is.

#include <complex>
#include <vector>

namespace gcs {

/// Exactly one solution, or so many as a cluster has, has |Re x_i − Re mid_i| ≤ Re radius_i and the same for
/// the imaginary parts; and no other one has |x_i − mid_i| ≤ unique for all i.
struct Enclosure {
  std::vector<std::complex<double>> mid;
  std::vector<std::complex<double>> radius;
  double unique = 0;
};

}  // namespace gcs
