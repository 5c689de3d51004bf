#pragma once
/// The first construction plan of a scene.

#include <optional>
#include <string>
#include <vector>

#include "solvers/construction/exchange.hpp"
#include "solvers/construction/plan.hpp"

namespace gcs {

/// A plan with the fewest driving parameters that placing points one by one allows, each point constrained to
/// at least one earlier one; among those, the one in which driving parameters appear latest. Exact for up to
/// 20 points (dynamic programming over the sets of points placed), greedy beyond. Where a point has more
/// constraints than it needs, or a driving parameter may be measured from several points, the choice that is
/// farthest from a boundary configuration in `figure` is taken. Precondition: no lines, a well posed problem,
/// positions fixed for none or for enough points.
Plan derive_plan(const Scene& scene, const Figure& figure, const ExchangeRule& rule);

/// The order in which derive_plan places the points that are not fixed. Same preconditions, but for one line in
/// space with no positions fixed: then the first point is one at a given distance from it, and the line counts
/// like a point that is placed. Empty where there is no such order.
std::vector<int> placing_order(const Scene& scene);

/// The plan that the file gives in `construction`, with its driven spheres centred where the points named are
/// in `figure`. Precondition: problem().construction is not empty.
Plan given_plan(const Scene& scene, const Figure& figure);

/// The given plan if there is one, otherwise the derived one. Precondition: a sketch, and nothing from
/// why_no_plan.
Plan first_plan(const Scene& scene, const ExchangeRule& rule);

/// Why a scene without lines has no construction plan of this kind (too few fixed positions to build on), or
/// nothing.
std::optional<std::string> why_no_plan(const Scene& scene);

/// The figure moved into the frame in which the plan builds.
Figure in_plan_frame(const Scene& scene, const Plan& plan, const Figure& figure);

/// The plan in words, a text for each instruction: "p4 = interSSS(p1, a4, p2, a5, p3', k1)".
std::vector<std::string> describe_plan(const Scene& scene, const Plan& plan);

}  // namespace gcs
