#pragma once
/// Where a step of a plan can place its element, at given angles: the instructions of construction/closed_forms.hpp.
///
/// A sphere that planes cut is most of it. Of a point the sphere is around another point, and what a further sphere has in
/// common with it lies in a plane. Of a plane n·x = h the normal lies on the unit sphere, h follows from one point's
/// distance, and every further distance or product is linear in n; so are the normal of a line in the plane and the
/// direction of a line through a point. Where a sign is not given both are taken.

#include <array>
#include <vector>

#include "solvers/construction/element_plan.hpp"

namespace gcs {

struct PlacedElement {
  Figure figure;
  /// The surfaces miss each other by no more than the slack, and the element is where they are nearest: at angles close
  /// by they may meet.
  bool misses = false;
};

class ElementPlaces {
 public:
  /// `slack`: how far surfaces may miss each other, in the scene's unit. The scene outlives this.
  ElementPlaces(const Scene& scene, double slack)
      : problem_(scene.problem()), slack_(slack), slack_of_directions_(slack / scene.size()) {}

  /// Every way to place the element of a step in the figure, which has what is placed before.
  std::vector<PlacedElement> of(const ElementStep& step, const Figure& figure,
                                const std::array<double, 2>& angles) const;

 private:
  const ProblemStatement& problem_;
  double slack_, slack_of_directions_;
};

}  // namespace gcs
