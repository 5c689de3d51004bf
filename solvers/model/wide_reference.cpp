#include "solvers/model/wide_reference.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "solvers/model/frame_choice.hpp"

namespace gcs {
namespace {

constexpr double wide = 0.125;  ///< of the scene's size

/// Given lengths between points.
class EdgeLengths {
 public:
  explicit EdgeLengths(const Scene& scene) : neighbours_(static_cast<std::size_t>(scene.point_count())) {
    for (std::size_t i = 0; i < scene.problem().constraints.size(); ++i) {
      const auto& [a, b] = scene.problem().constraints[i].between;
      const double length = scene.target_lengths()[i];
      neighbours_[a].emplace(b, length);
      neighbours_[b].emplace(a, length);
    }
  }

  /// With the length to each, in their order.
  const std::map<int, double>& neighbours(int point) const { return neighbours_[point]; }

  /// The shortest edge of a frame that is pairwise constrained; nothing of others.
  std::optional<double> shortest(const Reference& reference) const {
    double length = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : {std::pair{reference.origin, reference.axis},
                               {reference.origin, reference.plane},
                               {reference.axis, reference.plane}}) {
      if (a < 0 || b < 0) continue;
      const auto edge = neighbours_[a].find(b);
      if (edge == neighbours_[a].end()) return std::nullopt;
      length = std::min(length, edge->second);
    }
    return length;
  }

 private:
  std::vector<std::map<int, double>> neighbours_;
};

/// All pairwise constrained frames, each once.
std::vector<Reference> constrained_frames(const EdgeLengths& lengths, int points, int dimension) {
  std::vector<Reference> frames;
  for (int origin = 0; origin < points; ++origin)
    for (const auto& [axis, length] : lengths.neighbours(origin)) {
      if (axis < origin) continue;
      if (dimension == 2) frames.push_back({origin, axis, -1});
      for (const auto& [plane, other] : lengths.neighbours(origin))
        if (dimension == 3 && plane > axis && lengths.neighbours(axis).count(plane) > 0)
          frames.push_back({origin, axis, plane});
    }
  return frames;
}

}  // namespace

Reference wide_reference(const Scene& scene) {
  Reference best = scene.reference();
  if (scene.has_lines() && best.line < 0) return line_reference(scene.problem());
  if (scene.has_lines() || scene.is_anchored()) return best;
  const EdgeLengths lengths(scene);
  auto longest = lengths.shortest(best);
  if (!longest || *longest >= wide * scene.size()) return best;
  for (const Reference& candidate : constrained_frames(lengths, scene.point_count(), scene.dimension())) {
    const auto shortest = lengths.shortest(candidate);
    if (!shortest || *shortest <= *longest) continue;
    longest = shortest;
    best = candidate;
  }
  return best;
}

}  // namespace gcs
