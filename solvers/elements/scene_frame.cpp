#include "solvers/elements/scene_frame.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace gcs {
namespace {

/// Disjoint sets of 0 … n − 1.
class Sets {
 public:
  explicit Sets(int n) : root_(static_cast<std::size_t>(n)) { std::iota(root_.begin(), root_.end(), 0); }
  int find(int i) const {
    while (root_[static_cast<std::size_t>(i)] != i) i = root_[static_cast<std::size_t>(i)];
    return i;
  }
  void join(int a, int b) { root_[static_cast<std::size_t>(find(a))] = find(b); }

 private:
  std::vector<int> root_;
};

bool is_in_a_body(const ProblemStatement& problem, int entity) {
  return std::any_of(problem.bodies.begin(), problem.bodies.end(), [&](const RigidBody& body) {
    return std::any_of(body.elements.begin(), body.elements.end(),
                       [&](const BodyElement& element) { return element.entity == entity; });
  });
}

/// The points that a frame needs, of those that the scene's reference names.
std::vector<int> frame_points(const Scene& scene) {
  const Reference& reference = scene.reference();
  std::vector<int> points{reference.origin, reference.axis};
  if (scene.dimension() == 3) points.push_back(reference.plane);
  return points;
}

std::pair<int, int> sorted(int a, int b) { return std::minmax(a, b); }

bool is_between_segments(const Relation& relation) {
  return relation.of.size() == 2 && relation.of[0].is_segment() && relation.of[1].is_segment();
}

bool is_between_planes(const ProblemStatement& problem, const Relation& relation) {
  return relation.of.size() == 2 &&
         std::all_of(relation.of.begin(), relation.of.end(),
                     [&](const Operand& of) { return !of.is_segment() && problem.is_plane(of.entity); });
}

/// Whether the value of a relation with a plane is seen from a side of it.
bool has_sign(const ProblemStatement& problem, const Relation& relation) {
  return relation.type == RelationType::distance &&
         std::none_of(relation.of.begin(), relation.of.end(),
                      [&](const Operand& of) { return problem.is_line(of.entity); });
}

/// Numbers of the sets whose members are all free, −1 for members of the others.
std::vector<int> numbered(const Sets& sets, const std::vector<bool>& is_held) {
  const int n = static_cast<int>(is_held.size());
  std::vector<bool> held(is_held.size());
  for (int i = 0; i < n; ++i)
    if (is_held[static_cast<std::size_t>(i)]) held[static_cast<std::size_t>(sets.find(i))] = true;
  std::vector<int> number(is_held.size(), -1), of_root(is_held.size(), -1);
  int next = 0;
  for (int i = 0; i < n; ++i) {
    const auto root = static_cast<std::size_t>(sets.find(i));
    if (held[root]) continue;
    if (of_root[root] < 0) of_root[root] = next++;
    number[static_cast<std::size_t>(i)] = of_root[root];
  }
  return number;
}

}  // namespace

std::optional<std::string> why_no_frame(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  if (problem.is_anchored() || problem.reference_body >= 0) return std::nullopt;
  for (const int point : frame_points(scene))
    if (point < 0 || point >= scene.point_count() || is_in_a_body(problem, point))
      return problem.dimension == 3
                 ? "a frame is put in a body or in three points, which this scene does not have"
                 : "a frame is put in a body or in two points, which this scene does not have";
  return std::nullopt;
}

SceneFrame::SceneFrame(const Scene& scene) : reference_(scene.reference()) {
  const Convention convention = convention_of(scene.problem());
  if (convention == Convention::in_the_given_frame) {
    reference_ = {};
    return;
  }
  body_ = scene.problem().reference_body;
  if (body_ >= 0) {
    reference_ = {};
    if (convention == Convention::up_to_reflection)
      axes_[static_cast<std::size_t>(scene.dimension() - 1)] = 1;
    return;
  }
  // The group of all reflections in the planes of the frame, or its rotations.
  if (scene.dimension() == 3)
    axes_ = convention == Convention::up_to_reflection ? std::array<SignMask, 3>{1, 2, 4}
                                                       : std::array<SignMask, 3>{1, 3, 2};
  else
    axes_ = convention == Convention::up_to_reflection ? std::array<SignMask, 3>{1, 2, 0}
                                                       : std::array<SignMask, 3>{1, 1, 0};
}

bool SceneFrame::is_zero(int point, int axis) const {
  if (point == reference_.origin) return true;
  if (point == reference_.axis) return axis > 0;
  return point == reference_.plane && axis > 1;
}

Turnings::Turnings(const ProblemStatement& problem) {
  const int planes = static_cast<int>(problem.planes.size());
  Sets plane_sets(planes);
  std::vector<bool> has_side(problem.planes.size());
  for (int plane = 0; plane < planes; ++plane)
    has_side[static_cast<std::size_t>(plane)] =
        problem.is_fixed(static_cast<int>(problem.points.size() + problem.lines.size()) + plane) ||
        is_in_a_body(problem, static_cast<int>(problem.points.size() + problem.lines.size()) + plane);
  std::vector<std::pair<int, int>> pairs;
  const auto number_of = [&](const Operand& segment) {
    const auto pair = sorted(segment.entity, segment.end);
    const auto found = std::find(pairs.begin(), pairs.end(), pair);
    if (found != pairs.end()) return static_cast<int>(found - pairs.begin());
    pairs.push_back(pair);
    return static_cast<int>(pairs.size()) - 1;
  };
  std::vector<std::pair<int, int>> joined;
  for (const Relation& relation : problem.relations) {
    if (is_between_planes(problem, relation) && relation.type == RelationType::angle)
      plane_sets.join(problem.plane_of(relation.of[0].entity), problem.plane_of(relation.of[1].entity));
    for (const Operand& of : relation.of) {
      if (of.is_segment())
        number_of(of);
      else if (problem.is_plane(of.entity) && has_sign(problem, relation))
        has_side[static_cast<std::size_t>(problem.plane_of(of.entity))] = true;
    }
    if (is_between_segments(relation) && relation.type == RelationType::angle)
      joined.emplace_back(number_of(relation.of[0]), number_of(relation.of[1]));
  }
  planes_ = numbered(plane_sets, has_side);

  Sets segment_sets(static_cast<int>(pairs.size()));
  for (const auto& [a, b] : joined) segment_sets.join(a, b);
  std::vector<bool> has_length(pairs.size());
  for (const DistanceConstraint& c : problem.constraints) {
    const auto found = std::find(pairs.begin(), pairs.end(), sorted(c.between[0], c.between[1]));
    if (found != pairs.end()) has_length[static_cast<std::size_t>(found - pairs.begin())] = !c.is_squared;
  }
  const std::vector<int> numbers = numbered(segment_sets, has_length);
  for (std::size_t i = 0; i < pairs.size(); ++i) segments_[pairs[i]] = numbers[i];
}

int Turnings::of_segment(int a, int b) const { return segments_.at(sorted(a, b)); }

}  // namespace gcs
