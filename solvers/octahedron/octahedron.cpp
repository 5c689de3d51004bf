#include "solvers/octahedron/octahedron.hpp"

#include <algorithm>
#include <utility>

namespace gcs {

double roundness_of_base(const PairEntries& entries, const Octahedron& octahedron) {
  const int a = octahedron.pair[0][0];
  const int b = octahedron.pair[1][0];
  const int c = octahedron.pair[2][0];
  if (entries.is_plane(a) || entries.is_plane(b) || entries.is_plane(c)) return -1;
  const double longest = std::max({entries(a, b), entries(b, c), entries(c, a)});
  const double u = entries(a, b) / longest;
  const double v = entries(b, c) / longest;
  const double w = entries(c, a) / longest;
  return 2 * (u * v + v * w + w * u) - (u * u + v * v + w * w);
}

Octahedron with_round_base(const Octahedron& octahedron, const PairEntries& entries) {
  Octahedron best = octahedron;
  for (int swaps = 1; swaps < 8; ++swaps) {
    Octahedron other = octahedron;
    for (int i = 0; i < 3; ++i)
      if (swaps >> i & 1) std::swap(other.pair[i][0], other.pair[i][1]);
    if (roundness_of_base(entries, other) > roundness_of_base(entries, best)) best = other;
  }
  return best;
}

}  // namespace gcs
