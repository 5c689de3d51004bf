#pragma once
/// Scenes that move for reasons that nothing here proves, such as Bricard's octahedra or platforms on equal legs.
///
/// There one equation depends on the others at a real solution; where it stays met along the curve that the others leave, to
/// rounding, the scene seems to move.

#include <functional>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {

/// The motion of a real zero next to `start`, or of one from starts at random, of the scene's unit, if it seems to move.
/// `equations`: as many as unknowns. `figure_of`: in the scene's frame and unit.
std::optional<Motion> apparent_motion(const Scene& scene, const RealEquations& equations,
                                      Eigen::VectorXd start,
                                      const std::function<Figure(const Eigen::VectorXd&)>& figure_of,
                                      std::mt19937_64& random);

/// What tells a scene that seems to move in words.
inline constexpr std::string_view seems_to_move_words = "it seems to move";

/// What seems to move, in words of a person; empty when nothing does.
std::string apparent_in_words(const std::vector<Motion>& motions);

}  // namespace gcs
