#pragma once
/// Newton's method where the equations all but hold along a curve, as next to a flexible figure.
///
/// Let u and v be the singular vectors of the least singular value σ of the Jacobian. Where the others are far larger,
/// F(x) + τ·u = 0 is a regular curve through the solutions near by, which are where τ = 0 (Lyapunov and Schmidt's
/// reduction; bordered matrices: Govaerts 2000). A step along the curve, to where its tangent makes τ vanish, is
/// followed by Newton's method back to the curve, the last equation of which keeps it at right angles to v. As τ changes
/// by σ where x does by 1, coordinates that are doubles leave it undecided within a unit roundoff over σ; here they are
/// in double-double.

#include <Eigen/Core>
#include <optional>

#include "solvers/tracking/real_equations.hpp"

namespace gcs {

/// The solution that steps from `near` lead to, rounded to doubles; nothing where they do not shrink, or are longer than
/// `most`, in the unit of the unknowns. Precondition: as many equations as unknowns.
std::optional<Eigen::VectorXd> flat_refinement(const WideEquations& equations, const Eigen::VectorXd& near,
                                               double most);

}  // namespace gcs
