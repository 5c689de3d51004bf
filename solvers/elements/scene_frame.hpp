#pragma once
/// Where a general scene stands, and what may be mirrored or turned over without leaving a solution's class.

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "solvers/model/scene.hpp"
#include "solvers/numeric/sign_masks.hpp"

namespace gcs {

/// A frame is put in a body, or three points (two in the plane), or other elements (see Reference), or given by positions;
/// where these leave motions, it is put in them first.
class SceneFrame {
 public:
  explicit SceneFrame(const Scene& scene);

  /// The body that is not moved; −1: none.
  int body() const { return body_; }
  /// The elements that it is put in; none where it is put in a body or given.
  const Reference& reference() const { return reference_; }
  /// Whether the frame puts a line or a plane so that it goes through the origin.
  bool puts_through_origin(int entity) const { return passes_.contains(entity); }
  /// Of the components of vectors, for the reflections or half-turns that the frame leaves.
  SignMask axis(int i) const { return axes_[static_cast<std::size_t>(i)]; }
  /// Of the sign that a mirror image gives to a product of three vectors.
  SignMask mirror() const { return axes_[0] ^ axes_[1] ^ axes_[2]; }

 private:
  void find_passing(const ProblemStatement& problem);
  void find_reflections(const Scene& scene);
  void find_half_turns(const Scene& scene);
  /// By a plane with a side.
  bool is_axis_directed(const ProblemStatement& problem) const;

  int body_ = -1;
  Reference reference_;
  std::set<int> passes_;
  std::array<SignMask, 3> axes_{};
};

/// Why no frame can be found, in a sentence; nothing where one can.
std::optional<std::string> why_no_frame(const Scene& scene);

/// How a plane's normal follows from the direction of another line or plane.
struct SharedNormal {
  int leader = -1;             ///< the entity; −1: the normal is its own
  bool is_either_way = false;  ///< whether it may be the opposite, which is another solution
};

/// Of each plane. Planes that are parallel to each other or perpendicular to one line have one normal where one of them
/// may be turned over, or the line's direction where that is there before.
std::vector<SharedNormal> shared_normals(const ProblemStatement& problem);

/// Lines or planes that have their directions from bodies or given positions, and that a relation gives one.
struct DirectionsMadeOne {
  std::array<int, 2> entities{};
  int relation = -1;
};

/// All relations that say so, directly or by way of free lines and planes; none where those before it say as much.
std::vector<DirectionsMadeOne> directions_made_one(const ProblemStatement& problem);

/// Sets of planes, and of segments, that may be turned over together.
class Turnings {
 public:
  explicit Turnings(const ProblemStatement& problem);

  /// The number of the set that a plane is in; −1: it has a side.
  int of_plane(int plane) const { return planes_[static_cast<std::size_t>(plane)]; }
  /// That of a segment, whose length may be minus a root; −1: a constraint gives its length.
  int of_segment(int a, int b) const;

 private:
  static std::vector<int> turned_planes(const ProblemStatement& problem);
  static std::map<std::pair<int, int>, int> turned_segments(const ProblemStatement& problem);

  std::vector<int> planes_;
  std::map<std::pair<int, int>, int> segments_;
};

}  // namespace gcs
