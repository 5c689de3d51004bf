#pragma once
/// Octahedra: six points with all distances but three disjoint ones.

#include <Eigen/Core>
#include <array>
#include <optional>

#include "solvers/model/scene.hpp"
#include "solvers/structure/core_reduction.hpp"

namespace gcs {

/// Squared target lengths by the points' numbers; 0 where none is given.
class SquaredLengths {
 public:
  explicit SquaredLengths(const Scene& scene);
  double operator()(int p, int q) const { return matrix_(p, q); }

 private:
  Eigen::MatrixXd matrix_;
};

/// The six points in three opposite pairs: (a, a'), (b, b'), (c, c').
struct Octahedron {
  std::array<std::array<int, 2>, 3> pair;
};

/// The core of the scene as an octahedron, if it is one.
std::optional<Octahedron> find_octahedron(const Scene& scene, const CoreReduction& reduction);

/// Of the triangle abc: 16 area² over the fourth power of the longest side; at most 3, and 0 where it is
/// flat.
double roundness_of_base(const SquaredLengths& lengths, const Octahedron& octahedron);

/// Points swapped within pairs so that the triangle abc, on which all else is placed, is as round as can be.
Octahedron with_round_base(const Octahedron& octahedron, const SquaredLengths& lengths);

}  // namespace gcs
