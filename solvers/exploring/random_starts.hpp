#pragma once
/// Solutions from random starts, by Newton's method, damped.
///
/// A start places every point at random in a box, minimises Σ f_i² over the free coordinates, with
/// f_i = (|p_j − p_k|² − a_i²)/2, by the Levenberg-Marquardt method (Moré, The Levenberg-Marquardt algorithm:
/// implementation and theory, 1978: MINPACK's lmder, which Eigen has in C++), and ends with undamped steps
/// whose residuals are taken in double-double. An end that satisfies all distances to rounding is a solution,
/// unless the Jacobian there is singular or nearly so and no simple solution is proven next to it; any other is a local
/// minimum.
///
/// Of a general scene (elements/scene_system.hpp) points start in the box too, and directions and rotations are random. What an
/// orientation leaves out has basins like the rest.

#include <vector>

#include "solvers/exploring/proven_neighbours.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// One over the square root of the unit roundoff: at this condition number a fold is so near that the
/// rounding of the lengths can make the solution meet another one and vanish.
inline constexpr double singular_solution_condition = 9.5e7;

/// What became of one start. The figure is a representative of its class.
struct StartEnd {
  bool is_solution = false;
  bool is_singular = false;
  Figure figure;
  SolutionAccuracy accuracy;
  WorkCounters work;
};

/// The ends of the starts from `first` to before `last`, in their order, whatever the number of threads: the seed and its
/// number alone say where a start lies. Stopped, the rest are as if they had not ended. Singular ones are solutions where
/// `neighbours` proves so; of several next to one end, one is in its place and the others come after all ends. Precondition:
/// !why_not_explored(request.scene).
std::vector<StartEnd> ends_of_starts(const SolveRequest& request, int first, int last,
                                     ProvenNeighbours& neighbours);

}  // namespace gcs
