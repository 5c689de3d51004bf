#include "solvers/model/wide_reference.hpp"

#include <algorithm>
#include <limits>

namespace gcs {
namespace {

constexpr double wide = 0.125;  ///< of the scene's size

class EdgeLengths {
 public:
  explicit EdgeLengths(const Scene& scene) : scene_(scene) {}

  /// Of the given length between two points; nothing where none is given.
  std::optional<double> between(int a, int b) const {
    for (int i = 0; i < scene_.constraint_count(); ++i) {
      const auto& ends = scene_.problem().constraints[static_cast<std::size_t>(i)].between;
      if ((ends[0] == a && ends[1] == b) || (ends[0] == b && ends[1] == a))
        return scene_.target_lengths()[static_cast<std::size_t>(i)];
    }
    return std::nullopt;
  }

  /// The shortest edge of a frame that is pairwise constrained; nothing of others.
  std::optional<double> shortest(const Reference& reference) const {
    double length = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : {std::pair{reference.origin, reference.axis},
                               {reference.origin, reference.plane},
                               {reference.axis, reference.plane}}) {
      if (a < 0 || b < 0) continue;
      const auto edge = between(a, b);
      if (!edge) return std::nullopt;
      length = std::min(length, *edge);
    }
    return length;
  }

 private:
  const Scene& scene_;
};

}  // namespace

Reference wide_reference(const Scene& scene) {
  const EdgeLengths lengths(scene);
  Reference best = scene.reference();
  if (scene.has_lines() || scene.is_anchored()) return best;
  auto longest = lengths.shortest(best);
  if (!longest || *longest >= wide * scene.size()) return best;
  const int n = scene.point_count(), last = scene.dimension() == 3 ? n : 1;
  for (int origin = 0; origin < n; ++origin)
    for (int axis = origin + 1; axis < n; ++axis)
      for (int third = scene.dimension() == 3 ? axis + 1 : 0; third < last; ++third) {
        const Reference candidate{origin, axis, scene.dimension() == 3 ? third : -1};
        const auto shortest = lengths.shortest(candidate);
        if (!shortest || *shortest <= *longest) continue;
        longest = shortest;
        best = candidate;
      }
  return best;
}

}  // namespace gcs
