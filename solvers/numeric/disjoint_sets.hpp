#pragma once
/// Disjoint sets of numbers that are joined two by two.

#include <cstddef>
#include <numeric>
#include <vector>

namespace gcs {

/// Of 0 … n − 1.
class DisjointSets {
 public:
  explicit DisjointSets(int n) : root_(static_cast<std::size_t>(n)) {
    std::iota(root_.begin(), root_.end(), 0);
  }

  /// The same for all members of a set.
  int find(int i) const {
    while (root_[static_cast<std::size_t>(i)] != i) i = root_[static_cast<std::size_t>(i)];
    return i;
  }
  void join(int a, int b) { root_[static_cast<std::size_t>(find(a))] = find(b); }

 private:
  std::vector<int> root_;
};

}  // namespace gcs
