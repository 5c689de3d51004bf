#include "solvers/tracking/sketched_unknowns.hpp"

#include <cmath>
#include <limits>

#include "solvers/elements/body_motion.hpp"
#include "solvers/numeric/dense_factors.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

/// The elements of a body that tell its pose, points and planes: where the file has them, in the scene's unit, and where a
/// figure does.
struct BodyElements {
  std::vector<int> entities;
  std::vector<ElementPosition> given, seen;

  BodyElements(const Scene& scene, const RigidBody& body, const Figure& figure) {
    for (const BodyElement& element : body.elements) {
      if (scene.problem().is_line(element.entity)) continue;
      entities.push_back(element.entity);
      given.push_back(position_in_body(scene.problem(), element, -scene.unit_exponent()));
      seen.push_back(position_of(scene.problem(), element.entity, figure));
    }
  }
};

/// With the bodies as the file gives them, near to where they are sketched.
Figure with_rigid_bodies(const Scene& scene, const Figure& figure) {
  Figure result = figure;
  for (const RigidBody& body : scene.problem().bodies) {
    const BodyElements elements(scene, body, figure);
    const BodyMotion motion = nearest_motion(elements.given, elements.seen, scene.dimension());
    for (std::size_t i = 0; i < elements.entities.size(); ++i)
      put(scene.problem(), elements.entities[i], motion(elements.given[i]), result);
  }
  return result;
}

/// Moved to where the body that the frame is put in rests, if it is put in one.
Figure with_body_at_rest(const Scene& scene, Figure figure) {
  const ProblemStatement& problem = scene.problem();
  if (problem.reference_body < 0 || scene.is_anchored()) return figure;
  const BodyElements elements(scene, problem.bodies[static_cast<std::size_t>(problem.reference_body)],
                              figure);
  const BodyMotion motion = nearest_motion(elements.seen, elements.given, scene.dimension());
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    put(problem, entity, motion(position_of(problem, entity, figure)), figure);
  return figure;
}

}  // namespace

std::optional<SketchedUnknowns> sketched_unknowns(const Scene& scene, const SceneSystem& system) {
  constexpr int most_steps = 60;
  constexpr double settled = 1e-14, settled_at_all = 1e-10;
  const RealEquations equations = real_equations(system.equations());
  const std::vector<int> fixed = system.without_value();
  Eigen::VectorXd x = real_parts(
      system.coordinates_as_drawn(with_body_at_rest(scene, with_rigid_bodies(scene, *scene.sketch()))));
  const Eigen::VectorXd start = x;
  Eigen::MatrixXd jacobian(equations.count(), equations.unknowns);
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most_steps && !fixed.empty(); ++i) {
    equations.jacobian(x, jacobian);
    const Eigen::VectorXd excess = equations.sums(x) - equations.given;
    const Eigen::VectorXd step =
        shortest_solution(Eigen::MatrixXd(jacobian(fixed, Eigen::all)), excess(fixed));
    x -= step;
    const double size = step.norm() / (1 + x.norm());
    if (!std::isfinite(size)) return std::nullopt;
    const bool is_over = size <= settled || (size <= settled_at_all && size > last / 2);
    if (is_over) break;
    if (i + 1 == most_steps) return std::nullopt;
    last = size;
  }
  return SketchedUnknowns{x, (x - start).lpNorm<Eigen::Infinity>()};
}

}  // namespace gcs
