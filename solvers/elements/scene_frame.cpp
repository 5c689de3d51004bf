#include "solvers/elements/scene_frame.hpp"

#include <algorithm>
#include <numeric>

#include "solvers/elements/constraint_types.hpp"

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

/// The points that a frame needs, of those that the scene's reference names.
std::vector<int> frame_points(const Scene& scene) {
  const Reference& reference = scene.reference();
  std::vector<int> points{reference.origin, reference.axis};
  if (scene.dimension() == 3) points.push_back(reference.plane);
  return points;
}

std::pair<int, int> sorted(int a, int b) { return std::minmax(a, b); }

/// Whether a relation is an angle between two operands of that kind.
bool is_angle_between(const ProblemStatement& problem, const Relation& relation, OperandKind kind) {
  return value_kind(relation) == ConstraintType::Value::angle && kind_of(problem, relation.of[0]) == kind &&
         kind_of(problem, relation.of[1]) == kind;
}

/// Whether the value of a relation with a plane is seen from a side of it.
bool has_sign(const ProblemStatement& problem, const Relation& relation) {
  return value_kind(relation) == ConstraintType::Value::length &&
         std::none_of(relation.of.begin(), relation.of.end(),
                      [&](const Operand& of) { return problem.is_line(of.entity); });
}

bool is_in_a_body(const ProblemStatement& problem, const std::pair<int, int>& segment) {
  const std::vector<int> with_start = bodies_with(problem, segment.first),
                         with_end = bodies_with(problem, segment.second);
  return std::ranges::find_first_of(with_start, with_end) != with_start.end();
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
    if (point < 0 || point >= scene.point_count() || !bodies_with(problem, point).empty())
      return problem.dimension == 3
                 ? "a frame is put in a body or in three points, which this scene does not have"
                 : "a frame is put in a body or in two points, which this scene does not have";
  return std::nullopt;
}

SceneFrame::SceneFrame(const Scene& scene) {
  const Convention convention = convention_of(scene.problem());
  if (convention == Convention::in_the_given_frame) return;
  const bool is_mirrored = convention == Convention::up_to_reflection;
  body_ = scene.problem().reference_body;
  if (body_ >= 0) {
    if (is_mirrored) axes_[static_cast<std::size_t>(scene.dimension() - 1)] = 1;
    return;
  }
  reference_ = scene.reference();
  // The group of all reflections in the planes of the frame, or its rotations.
  if (scene.dimension() == 3)
    axes_ = is_mirrored ? std::array<SignMask, 3>{1, 2, 4} : std::array<SignMask, 3>{1, 3, 2};
  else
    axes_ = is_mirrored ? std::array<SignMask, 3>{1, 2, 0} : std::array<SignMask, 3>{1, 1, 0};
}

bool SceneFrame::is_zero(int point, int axis) const {
  if (point == reference_.origin) return true;
  if (point == reference_.axis) return axis > 0;
  return point == reference_.plane && axis > 1;
}

/// Planes with an angle between them are turned over together; one that has a side is not.
std::vector<int> Turnings::turned_planes(const ProblemStatement& problem) {
  const int planes = static_cast<int>(problem.planes.size());
  Sets sets(planes);
  std::vector<bool> has_side(problem.planes.size());
  for (int plane = 0; plane < planes; ++plane) {
    const int entity = problem.plane_entity(plane);
    has_side[static_cast<std::size_t>(plane)] =
        problem.is_fixed(entity) || !bodies_with(problem, entity).empty();
  }
  for (const Relation& relation : problem.relations) {
    if (is_angle_between(problem, relation, OperandKind::plane))
      sets.join(problem.plane_of(relation.of[0].entity), problem.plane_of(relation.of[1].entity));
    for (const Operand& of : relation.of)
      if (kind_of(problem, of) == OperandKind::plane && has_sign(problem, relation))
        has_side[static_cast<std::size_t>(problem.plane_of(of.entity))] = true;
  }
  return numbered(sets, has_side);
}

/// Likewise segments; one whose length is given, or that a body has, is not.
std::map<std::pair<int, int>, int> Turnings::turned_segments(const ProblemStatement& problem) {
  std::map<std::pair<int, int>, int> segments;
  const auto number_of = [&](const Operand& segment) {
    return segments.emplace(sorted(segment.entity, segment.end), static_cast<int>(segments.size()))
        .first->second;
  };
  std::vector<std::pair<int, int>> joined;
  for (const Relation& relation : problem.relations) {
    for (const Operand& of : relation.of)
      if (of.is_segment()) number_of(of);
    if (is_angle_between(problem, relation, OperandKind::segment))
      joined.emplace_back(number_of(relation.of[0]), number_of(relation.of[1]));
  }
  Sets sets(static_cast<int>(segments.size()));
  for (const auto& [a, b] : joined) sets.join(a, b);
  std::vector<bool> has_length(segments.size());
  for (const auto& [segment, number] : segments)
    has_length[static_cast<std::size_t>(number)] = is_in_a_body(problem, segment);
  for (const DistanceConstraint& c : problem.constraints)
    if (const auto found = segments.find(sorted(c.between[0], c.between[1])); found != segments.end())
      has_length[static_cast<std::size_t>(found->second)] = !c.is_squared;
  const std::vector<int> numbers = numbered(sets, has_length);
  for (auto& [pair, number] : segments) number = numbers[static_cast<std::size_t>(number)];
  return segments;
}

Turnings::Turnings(const ProblemStatement& problem)
    : planes_(turned_planes(problem)), segments_(turned_segments(problem)) {}

int Turnings::of_segment(int a, int b) const { return segments_.at(sorted(a, b)); }

}  // namespace gcs
