#pragma once
/// The finite ends of paths, each once.

#include <cstddef>
#include <random>
#include <vector>

#include "solvers/homotopies/endgame.hpp"
#include "solvers/homotopies/mirror_images.hpp"

namespace gcs {

/// How uncertain a singular end is, relative to 1 + the largest |x_i|: Cauchy's formula is right to the
/// rounding of its samples, which a double root feels by its square root.
inline constexpr double singular_uncertainty = 1e-7;

/// Of every entry.
ComplexVectorX conjugate(ComplexVectorX x);

/// The finite ends, distinct up to signs, with the number of paths that end at each. Refers to the ends, which stay where
/// they are.
class DistinctEnds {
 public:
  DistinctEnds(const std::vector<PathEnd>& ends, SignMasks signs, std::mt19937_64& random);
  DistinctEnds(std::vector<PathEnd>&& ends, SignMasks signs, std::mt19937_64& random) = delete;

  int size() const { return index_.size(); }
  const ComplexVectorX& operator[](int i) const { return ends_[first_[i]].x; }
  int paths(int i) const { return paths_[i]; }
  /// Whether a path took end i for a singular one.
  bool is_singular(int i) const { return singular_[i]; }
  /// Whether it is right to its own rounding, entry by entry.
  bool is_precise(int i) const { return size_[i] == RelativeTo::each; }
  bool has_conjugate(int i) const;
  /// The number of regular ends at which several paths arrived.
  int jumps() const;

 private:
  int find(const ComplexVectorX& x, double uncertainty, RelativeTo size) const;

  const std::vector<PathEnd>& ends_;
  SolutionIndex index_;
  std::vector<std::size_t> first_;  ///< that ended there
  std::vector<int> paths_;
  std::vector<bool> singular_;
  std::vector<RelativeTo> size_;  ///< of each end's uncertainty
};

}  // namespace gcs
