#include "solvers/model/reframed_scene.hpp"

#include <utility>

#include "solvers/model/point_reference.hpp"

namespace gcs {

Scene with_reference(const Scene& scene, const Reference& reference) {
  ProblemStatement problem = scene.problem();
  problem.reference = reference;
  return Scene::unchecked(std::move(problem));
}

bool is_in_frame_of_line(const Scene& scene) { return !scene.is_anchored() && scene.reference().line >= 0; }

Reference reference_of_elements(const Scene& scene) {
  return is_in_frame_of_line(scene) ? point_reference(scene.problem()) : scene.reference();
}

Scene in_frame_of_elements(const Scene& scene) {
  return is_in_frame_of_line(scene) ? with_reference(scene, reference_of_elements(scene)) : scene;
}

}  // namespace gcs
