#pragma once
/// A curve of figures, followed from a real one on.

#include <functional>
#include <optional>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {

/// The zero that Gauss–Newton steps of least length lead to from x, to rounding; nothing where they do not settle.
/// Directions that the equations hardly tell, by 1e-6 of the most, count as free.
std::optional<Eigen::VectorXd> real_zero_near(const RealEquations& equations, Eigen::VectorXd x);

/// So many steps of the tracker (tracking/series_tracker.hpp) to either side at most, with eight figures each.
inline constexpr int most_motion_steps = 250;

/// The curve of these equations through x, in both directions until it is closed or ends. Each of its points is moved to the
/// zero of `met` next to it, `equations` themselves or more; where there is none within the accuracy of the tracker, the
/// residual is infinite and the figure left out. Mirror images are figures of their own. Precondition: one equation fewer
/// than unknowns, independent at x, which is a zero. `figure_of`: in the scene's unit.
FigureCurve motion_from(const Scene& scene, const RealEquations& equations, const RealEquations& met,
                        const Eigen::VectorXd& x,
                        const std::function<Figure(const Eigen::VectorXd&)>& figure_of, int most_steps);

}  // namespace gcs
