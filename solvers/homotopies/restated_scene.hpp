#pragma once
/// Scenes with given points and a free line as homotopies solve them, and the way back.

#include <optional>
#include <string>

#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/released_scene.hpp"

namespace gcs {

/// Why this is not for a scene, in a sentence. Nothing where it is.
std::optional<std::string> why_not_restated(const Scene& scene);

/// Without given positions (model/released_scene.hpp). Where four given points are so nearly on a line that the coordinates of
/// lines beside them exceed what doubles hold, they are moved apart first (tangents/strip.hpp), and the lines of that scene are
/// followed back (tangents/squeezed_tangents.hpp).
class RestatedScene {
 public:
  /// Precondition: !why_not_restated(given). Keeps a reference to the scene.
  explicit RestatedScene(const Scene& given);

  const ReleasedScene& released() const { return *released_; }

  /// The report on the given scene that a report on the released one amounts to: the solutions that can be carried back, with
  /// lines polished in the given frame (tangents/scene_spheres.hpp), and as many at generic lengths as have the given points
  /// where they are. Its paths are those of the released scene. Partial where a line is lost on the way back.
  SolveReport carried_back(const SolveRequest& request, SolveReport report) const;

 private:
  void squeeze(const SolveRequest& request, SolveReport& report) const;

  const Scene& given_;
  std::optional<Scene> widened_;  ///< with points that are moved apart
  std::optional<ReleasedScene> released_;
};

}  // namespace gcs
