#pragma once
/// The problem 5p1L of Hoffmann and Yuan (2000): an apex joined to the four points of a 4-cycle, and a line
/// at given distances from all five.

#include <array>
#include <optional>

#include "solvers/model/scene.hpp"

namespace gcs {

/// Points and given lengths, in the scene's unit. In the paper's words cycle[i] is p_{i+1} and the apex p_5.
struct Pyramid {
  int apex = -1;
  std::array<int, 4> cycle{};      ///< cycle[i] and cycle[i + 1 mod 4] are constrained
  std::array<double, 4> radius{};  ///< r_i: of cycle[i] to the line
  double apex_radius = 0;          ///< r_5: of the apex to the line
  std::array<double, 4> spoke{};   ///< d_i: of cycle[i] to the apex
  std::array<double, 4> side{};    ///< d_12, d_23, d_34, d_41: of cycle[i] to cycle[i + 1 mod 4]
};

/// The scene as a pyramid, if it is one: five points, one line, these 13 constraints, nothing fixed.
/// cycle[0] is the first of the four in the file's order of points, cycle[1] the first of its neighbours.
std::optional<Pyramid> find_pyramid(const Scene& scene);

}  // namespace gcs
