#include "solvers/counting/sphere_count.hpp"

#include "solvers/counting/realisation_count.hpp"
#include "solvers/structure/core_reduction.hpp"

namespace gcs {
namespace {

GraphEdges core_edges(const ProblemStatement& problem, const CoreReduction& reduction) {
  GraphEdges edges;
  for (const int constraint : reduction.core_constraints)
    edges.push_back(problem.constraints[constraint].between);
  return edges;
}

}  // namespace

SphereCount sphere_count(const ProblemStatement& problem, const RecursionLimits& limits) {
  if (problem.dimension != 2 || problem.is_general() || !problem.lines.empty() || problem.is_anchored())
    return {std::nullopt,
            "On the sphere the number is known for scenes of the plane, of points alone and nothing fixed."};
  const CoreReduction reduction = reduce_to_core(problem, {});
  const auto of_core =
      reduction.core_is_trivial ? Natural(1) : count_on_sphere(core_edges(problem, reduction), limits);
  if (!of_core) return {std::nullopt, why_given_up("cross ratios", reduction.core.size(), limits)};
  const int hanging = static_cast<int>(reduction.placed.size());
  return {SolutionCount{Natural::power_of_two(hanging) * *of_core, frame_images(problem)}, ""};
}

}  // namespace gcs
