#pragma once
/// Scenes with given positions and a free line, restated without given positions, so that the frame can put
/// the line on the x-axis as in other scenes, and the way back.
///
/// Four points that span space are the base, a rigid body by its six distances: of the given points three of
/// a large triangle and one off their plane. Where none is well off it, because the given points are
/// coplanar, a further point is added there: at a flat base distances are stationary and all solutions
/// singular. Likewise for the triangle, where they are nearly collinear. Every other given point has its
/// distances from the three base points from whose plane it is furthest; they admit its mirror image in that
/// plane too, so each such point doubles the number of placements.
///
/// Placements that differ by reflections are one class, half of which have the base in its given orientation:
/// one up to motions. The complex motion that takes its base to the given positions carries it back. It takes
/// the other given points to their positions too, or else to mirror images: these placements are no
/// solutions.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "solvers/model/scene.hpp"

namespace gcs {

/// Why the restatement is not for this scene, in a sentence: it needs one free line, and given points in
/// different places that are not collinear (to 1e-6 of the longest distance). Nothing where it is.
std::optional<std::string> why_not_released(const Scene& scene);

class ReleasedScene {
 public:
  /// Precondition: !why_not_released(given). Keeps a reference to the scene.
  explicit ReleasedScene(const Scene& given);

  /// The restated scene: the points in their order, up to two more, and the line; the constraints in their
  /// order, then the distances of given points.
  const Scene& scene() const { return *free_; }
  /// 2^(this) placements of given points have the same distances, one of which is the given one.
  int doublings() const { return static_cast<int>(attached_.size()); }
  /// The figure of the given scene that this one, a solution in the frame of scene(), is in all its mirror
  /// images; its line is normalised (complex_lines.hpp). Nothing where given points would be elsewhere.
  std::optional<Figure> carried_back(const Figure& figure) const;

 private:
  /// A given point that is not of the base, by its distances from three points of it.
  struct Attached {
    int point = 0;
    std::array<int, 3> base{};  ///< places in base_
  };

  /// Sets base_points_ and base_; returns the given points that are not among them.
  std::vector<int> choose_base();
  ProblemStatement released_problem() const;
  Eigen::Vector3d given_position(int point) const;
  Attached attached(int point) const;
  bool is_where_given(const Attached& attached, const Eigen::Vector3cd& position) const;

  const Scene& given_;
  std::vector<int> base_points_;      ///< four, numbered as in scene()
  int added_points_ = 0;              ///< those of the base that are not given, after the scene's own
  Eigen::Matrix<double, 3, 4> base_;  ///< positions, in the given scene's unit
  std::vector<Attached> attached_;
  std::optional<Scene> free_;
};

}  // namespace gcs
