#include "solvers/exploring/proven_neighbours.hpp"

#include <algorithm>
#include <limits>

#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/certificates/proven_error.hpp"
#include "solvers/certificates/scene_equations.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/exploring/explored_scene.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {
namespace {

/// At a fold there are two, and their mirror images by a short edge.
constexpr int most_solutions = 4;

/// Of a figure in the scene's frame.
std::vector<Candidate> solutions_next_to(const Scene& scene, const Figure& framed) {
  std::vector<Candidate> found;
  if (is_explored_by_elements(scene)) {
    const SceneSystem system(scene);
    found = simple_solutions_near(system, system.coordinates(framed), most_solutions, {}).list;
  } else if (!scene.has_lines()) {
    found = resolve_nearly_singular(scene, {{framed, most_solutions}}, {}, most_solutions, {}).list;
  }
  std::erase_if(found, [](const Candidate& candidate) {
    return !candidate.figure.is_real() || candidate.multiplicity > 1;
  });
  return found;
}

}  // namespace

/// The first place that is the same to the coarsest tolerance of classes, or one more.
std::size_t ProvenNeighbours::place_of(const Figure& representative) const {
  std::vector<Figure> all = places_;
  all.push_back(representative);
  const std::vector<SolutionAccuracy> coarse(all.size(), {std::numeric_limits<double>::infinity()});
  return static_cast<std::size_t>(solution_classes(scene_, all, coarse).class_of.back());
}

const std::vector<Candidate>& ProvenNeighbours::of(const Figure& figure) {
  const std::size_t place = place_of(scene_.representative(figure));
  if (place == places_.size()) {
    places_.push_back(scene_.representative(figure));
    solutions_.push_back(solutions_next_to(scene_, scene_.in_frame(figure)));
    in_vain_ += solutions_.back().empty() ? 1 : 0;
  }
  return solutions_[place];
}

double ProvenNeighbours::error_of(const Figure& figure) const {
  if (is_explored_by_elements(scene_)) return std::numeric_limits<double>::infinity();
  return proven_error(scene_, target_squares(scene_), figure);
}

std::optional<Candidate> ProvenNeighbours::nearest(const Figure& figure) {
  const std::vector<Candidate>& solutions = of(figure);
  if (solutions.empty()) return std::nullopt;
  const SceneEquations equations(scene_);
  const std::vector<std::complex<double>> x = equations.coordinates(scene_.in_frame(figure));
  return *std::ranges::min_element(solutions, {}, [&](const Candidate& solution) {
    const std::vector<std::complex<double>> y = equations.coordinates(solution.figure);
    double distance = 0;
    for (std::size_t i = 0; i < x.size(); ++i) distance = std::max(distance, std::abs(x[i] - y[i]));
    return distance;
  });
}

}  // namespace gcs
