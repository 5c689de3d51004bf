#pragma once
/// How far a solution in doubles is from the solution that it stands for.

#include <optional>
#include <vector>

#include "solvers/certificates/scene_equations.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/scene.hpp"
#include "solvers/numeric/double_double.hpp"

namespace gcs {

/// A proven bound on the error of a figure in the scene's unit, up to a motion, for those that are stiff: of
/// a real one of points by Krawczyk's test in the smallest box that it holds in, of others by a certificate.
/// Infinite for others, where nothing is proven, and above 300 unknowns (100 for a certificate).
/// `squares`: see target_squares.
double proven_error(const Scene& scene, const std::vector<DoubleDouble>& squares, const Figure& figure);

/// Of a figure in the scene's unit and frame, by a certificate of the scene's equations, whatever its condition; infinity if
/// it proves none.
double certified_error(const SceneEquations& equations, const Certifier& certifier, const Figure& framed);

/// For each complex figure of points in the scene's frame the solution next to it, proven to be complex, rounded to doubles,
/// with its error: where these do not hold the distances, a figure is right only as far as it is that. Nothing where there
/// is none within a thousandth of the figure's size, beside lines, and above 100 unknowns.
std::vector<std::optional<Candidate>> proven_next_to(const Scene& scene,
                                                     const std::vector<const Figure*>& figures,
                                                     const SolveMeans& means);

}  // namespace gcs
