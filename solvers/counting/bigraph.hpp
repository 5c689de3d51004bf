#pragma once
/// Bigraphs [C, §3]: two multigraphs G and H on the same edges, here sides 0 and 1. The realisations of a
/// Laman graph L are those of the bigraph (L, L): with x_e = X_u − X_v and y_e = Y_u − Y_v for e = uv, in the
/// isotropic coordinates X, Y = x ± iy of the plane, the equations are x_e·y_e = λ_e for all edges, x a
/// potential difference on G and y one on H.
/// [C] J. Capco, M. Gallet, G. Grasegger, C. Koutschan, N. Lubbes, J. Schicho: The number of realizations of
/// a Laman graph. SIAM J. Appl. Algebra Geom. 2 (2018).

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace gcs {

/// A bit per edge.
using EdgeSet = std::uint64_t;
inline constexpr int most_biedges = 64;
/// On each side.
inline constexpr int most_bigraph_vertices = 64;

/// The ends of one edge in both graphs.
struct Biedge {
  std::array<std::array<std::uint8_t, 2>, 2> ends{};

  friend auto operator<=>(const Biedge&, const Biedge&) = default;
};

/// Vertices without edges do not count, and neither does how components hang together: only which edges form
/// cycles. At most most_biedges edges and most_bigraph_vertices vertices a side.
using Bigraph = std::vector<Biedge>;

/// The vertices of one side as edges are contracted.
class VertexClasses {
 public:
  VertexClasses();
  bool are_joined(const std::array<std::uint8_t, 2>& ends) const {
    return label_[ends[0]] == label_[ends[1]];
  }
  /// False when they were joined already.
  bool join(const std::array<std::uint8_t, 2>& ends);
  std::uint8_t operator[](std::uint8_t vertex) const { return label_[vertex]; }

 private:
  std::array<std::uint8_t, most_bigraph_vertices> label_{};
};

/// Rank of edges on one side: vertices less components of the subgraph that they make.
int rank(const Bigraph& bigraph, int side, EdgeSet edges);

/// All edges of the bigraph.
EdgeSet all_edges(const Bigraph& bigraph);

/// `edges` contracted on `side` and deleted on the other: ᴹB for side 0, Bᴺ for side 1.
Bigraph contracted(const Bigraph& bigraph, int side, EdgeSet edges);

/// Renames vertices and orders edges and sides by what the bigraph looks like around them, so that isomorphic
/// bigraphs mostly become equal. The result is isomorphic to what was given in any case.
Bigraph canonical(const Bigraph& bigraph);

}  // namespace gcs
