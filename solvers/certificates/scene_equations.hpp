#pragma once
/// The equations of a scene with the exact numbers of its file, for certificates. In the scene's unit, which
/// is a power of two of the file's, so that nothing is rounded.
///
/// Points: the squared distances in the free coordinates of the scene's frame. A line that the frame puts on
/// the x-axis: y² + z² = a². A line beside given points: its point p nearest to the origin and its direction u,
/// with u·u = 1, u·p = 0 and |c − p|² + |c × u|² − c·c = a² for each given point c.
/// General scenes: elements/scene_system.hpp.

#include <array>
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "solvers/certificates/certificate.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/model/quadratic_system.hpp"

namespace gcs {

/// Why certificates do not reach this scene, in a sentence; nothing where they do.
std::optional<std::string> why_not_certified(const Scene& scene);

class SceneEquations {
 public:
  /// Precondition: !why_not_certified(scene). Keeps a reference to the scene.
  explicit SceneEquations(const Scene& scene);

  /// At the lengths of the file.
  QuadraticSystem system() const { return general_ ? general_->equations() : system_; }
  /// At other squared lengths, one per constraint, in the scene's unit; of a general scene at other values, one for each
  /// equation that has one. Precondition: no given positions.
  QuadraticSystem system_at(const std::vector<std::complex<double>>& squares) const;

  /// The unknowns of a figure that is in the scene's frame.
  std::vector<std::complex<double>> coordinates(const Figure& figure) const;
  /// At most the largest distance of a point of the figure from its place in the solution that is proven
  /// next to it, or that the frame or the file gives, in the scene's unit. Of a line its point nearest to the
  /// origin counts, and its direction times the scene's size.
  double distance(const Figure& figure, const Certificate& certificate) const;
  /// The number of the unknown that is coordinate `axis` of a point, or −1 where it is given.
  int point_unknown(int point, int axis) const { return points_.unknown(point, axis); }
  /// Of the point of a line (part 0) or its direction (part 1); −1 for a line that the frame puts on the
  /// x-axis.
  int line_unknown(int line, int part, int axis) const;
  /// The system of a general scene, in which points, lines and planes are forms; null of any other.
  const SceneSystem* general() const { return general_ ? &*general_ : nullptr; }

 private:
  double general_distance(const Figure& figure, const Certificate& certificate) const;
  double offset_from_given(const Figure& figure, int point, int axis) const;
  QuadraticEquation distance_to_free_line(int constraint) const;
  void add_line_conditions(int line);

  const Scene& scene_;
  DistanceSystem points_;
  QuadraticSystem system_;
  std::optional<SceneSystem> general_;  ///< in the place of the two above
};

}  // namespace gcs
