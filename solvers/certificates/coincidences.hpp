#pragma once
/// Which of many proven solutions may be the same one, up to reflections.

#include <cstddef>
#include <functional>
#include <vector>

#include "solvers/model/enclosure.hpp"
#include "solvers/numeric/sign_masks.hpp"

namespace gcs {

/// Two solutions that are not proven to be different.
struct Coincidence {
  int first = 0;
  int second = 0;
  bool is_proven = false;  ///< they are the same one, or mirror images
};

/// All pairs of solutions whose boxes, or those of their mirror images, meet. Two solutions of one system are
/// different classes when the box of one misses every mirror image of the other's. `mirror`: see
/// QuadraticSystem. Ordered by first, then second. n log n for n solutions of which few meet. `box_of` is called for
/// each, and again where boxes may meet.
std::vector<Coincidence> coincidences(std::size_t solutions,
                                      const std::function<Enclosure(std::size_t)>& box_of,
                                      const SignMasks& mirror);
std::vector<Coincidence> coincidences(const std::vector<Enclosure>& solutions, const SignMasks& mirror);

/// How many of its mirror images, itself among them, may meet the box. Where it is alone what the box holds
/// are as many classes as solutions; otherwise they are at least so many times fewer, as many as that where
/// it holds solutions that are their own mirror images.
int meeting_images(const Enclosure& box, const SignMasks& mirror);

}  // namespace gcs
