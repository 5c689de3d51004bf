#include "solvers/elements/scene_frame.hpp"

#include <algorithm>

#include "solvers/elements/constraint_types.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/model/frame_choice.hpp"
#include "solvers/numeric/disjoint_sets.hpp"

namespace gcs {
namespace {

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
std::vector<int> numbered(const DisjointSets& sets, const std::vector<bool>& is_held) {
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

/// Whether a body or a given position puts an entity where it is before the others.
bool is_held(const ProblemStatement& problem, int entity) {
  return rests_in_frame(problem, entity) || !bodies_with(problem, entity).empty();
}

/// Lines and planes that relations give one direction, but for its sign; points are sets of their own.
DisjointSets direction_sets(const ProblemStatement& problem) {
  DisjointSets sets(problem.entity_count());
  for (Relation relation : problem.relations)
    if (const ConstraintKind* kind = find_kind(problem, relation); kind != nullptr && kind->shares_direction)
      sets.join(relation.of[0].entity, relation.of[1].entity);
  return sets;
}

/// Which planes are turned over together, those with an angle between them or one normal, and which have a side.
class PlaneSides {
 public:
  explicit PlaneSides(const ProblemStatement& problem)
      : problem_(problem),
        sets_(static_cast<int>(problem.planes.size())),
        has_side_(problem.planes.size()),
        normals_(problem.planes.size()) {
    for (int plane = 0; plane < planes(); ++plane)
      if (const int entity = problem.plane_entity(plane);
          problem.is_fixed(entity) || !bodies_with(problem, entity).empty())
        see_side(plane);
    for (const Relation& relation : problem.relations) state(relation);
    share_normals();
  }

  std::vector<int> numbers() const { return numbered(sets_, has_side_); }
  std::vector<SharedNormal> normals() const { return normals_; }

 private:
  int planes() const { return static_cast<int>(problem_.planes.size()); }
  void see_side(int plane) { has_side_[static_cast<std::size_t>(plane)] = true; }

  /// An angle turns both planes. A distance is seen from a side of its plane, of two from one of the first.
  void state(const Relation& relation) {
    if (is_angle_between(problem_, relation, OperandKind::plane))
      sets_.join(problem_.plane_of(relation.of[0].entity), problem_.plane_of(relation.of[1].entity));
    const auto plane = std::ranges::find_if(
        relation.of, [&](const Operand& of) { return kind_of(problem_, of) == OperandKind::plane; });
    if (plane != relation.of.end() && has_sign(problem_, relation))
      see_side(problem_.plane_of(plane->entity));
  }

  /// Whether a plane, with those that are turned with it, has a side.
  bool is_sided(int plane) const {
    for (int other = 0; other < planes(); ++other)
      if (sets_.find(other) == sets_.find(plane) && has_side_[static_cast<std::size_t>(other)]) return true;
    return false;
  }

  /// Of each set that which is held leads or, where none is, a plane, one with a side if there is one.
  void share_normals() {
    const DisjointSets directions = direction_sets(problem_);
    std::map<int, int> leaders;
    const auto lead = [&](int entity) { leaders.emplace(directions.find(entity), entity); };
    for (int entity = problem_.line_entity(0); entity < problem_.entity_count(); ++entity)
      if (is_held(problem_, entity)) lead(entity);
    for (int plane = 0; plane < planes(); ++plane)
      if (is_sided(plane)) lead(problem_.plane_entity(plane));
    for (int plane = 0; plane < planes(); ++plane) lead(problem_.plane_entity(plane));
    for (int plane = 0; plane < planes(); ++plane) {
      const int entity = problem_.plane_entity(plane), leader = leaders.at(directions.find(entity));
      if (entity != leader && !is_held(problem_, entity)) follow(plane, leader);
    }
  }

  void follow(int plane, int leader) {
    SharedNormal& normal = normals_[static_cast<std::size_t>(plane)];
    normal.leader = leader;
    const int other = problem_.is_plane(leader) ? problem_.plane_of(leader) : -1;
    normal.is_either_way = is_sided(plane) || (other >= 0 && sets_.find(plane) == sets_.find(other));
    if (normal.is_either_way) return;
    if (other >= 0)
      sets_.join(plane, other);
    else
      see_side(plane);
  }

  const ProblemStatement& problem_;
  DisjointSets sets_;
  std::vector<bool> has_side_;
  std::vector<SharedNormal> normals_;
};

}  // namespace

std::optional<std::string> why_no_frame(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  if (problem.is_anchored() || problem.reference_body >= 0) return std::nullopt;
  const Reference& frame = scene.reference();
  if (problem.file_frame && frame.origin < 0 && frame.axis < 0)
    return std::nullopt;  // all given elements, which are completed
  const bool has_points = frame.origin >= 0;
  std::vector<int> needed{frame.axis};
  if (has_points) needed.push_back(frame.origin);
  if (!has_points || problem.dimension == 3) needed.push_back(frame.plane);
  const bool is_plane_alone = !has_points && frame.axis >= 0 && problem.is_plane(frame.axis);
  if (is_plane_alone && !problem.is_line(frame.plane)) needed.push_back(frame.height);
  if (std::ranges::all_of(needed, [&](int entity) {
        return entity >= 0 && entity < problem.entity_count() &&
               (rests_in_frame(problem, entity) || bodies_with(problem, entity).empty());
      }))
    return std::nullopt;
  return problem.dimension == 3 ? "a frame is put in a body, in three points, or in two points, lines or "
                                  "planes whose directions no "
                                  "'parallel' or 'perpendicular' makes one, with a point or where these or "
                                  "three planes meet, which this "
                                  "scene does not have"
                                : "a frame is put in a body, in two points, in a point and a line, or in two "
                                  "lines that no 'parallel' "
                                  "joins, which this scene does not have";
}

SceneFrame::SceneFrame(const Scene& scene) {
  const Convention convention = frame_convention(scene.problem());
  if (convention == Convention::in_the_given_frame) return;
  const bool is_mirrored = convention == Convention::up_to_reflection;
  body_ = scene.problem().reference_body;
  if (body_ >= 0) {
    if (is_mirrored) axes_[static_cast<std::size_t>(scene.dimension() - 1)] = 1;
    return;
  }
  reference_ = scene.reference();
  find_passing(scene.problem());
  if (is_mirrored)
    find_reflections(scene);
  else
    find_half_turns(scene);
}

/// Without a point as the origin, lines and planes go through it, and beside a plane and a point of the axis just that;
/// beside given elements that leave a shift, a plane, or a line in the plane.
void SceneFrame::find_passing(const ProblemStatement& problem) {
  if (reference_.origin >= 0) return;
  if (reference_.axis < 0) {
    if (problem.is_plane(reference_.height) || problem.dimension == 2) passes_ = {reference_.height};
    return;
  }
  passes_ = {reference_.axis};
  if (reference_.height < 0 || !problem.is_point(reference_.height))
    passes_.insert({reference_.plane, reference_.height});
}

/// Those in all planes of the frame or, with a plane's side along the first axis, in those that leave it.
void SceneFrame::find_reflections(const Scene& scene) {
  if (!is_axis_directed(scene.problem())) axes_[0] = 1;
  axes_[1] = 2;
  if (scene.dimension() == 3) axes_[2] = 4;
}

/// Those about all axes of the frame that leave given elements, and a plane's side along the first axis.
void SceneFrame::find_half_turns(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  std::optional<GivenCoordinates> given;
  if (problem.file_frame && rest_in_frame(problem)) given.emplace(scene);
  const bool is_directed = is_axis_directed(problem);
  const auto is_left = [&](std::size_t about) {
    if (about != 2 && scene.dimension() == 2) return false;
    if (about != 0 && is_directed) return false;
    std::array<bool, 3> turned_over{true, true, true};
    turned_over[about] = false;
    return !given || given->are_kept(turned_over);
  };
  const auto add = [&](std::size_t about, SignMask generator) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (axis != about) axes_[axis] |= generator;
  };
  if (is_left(2) || is_left(1)) add(is_left(2) ? 2 : 1, 1);
  if (is_left(0)) add(0, 2);
}

bool SceneFrame::is_axis_directed(const ProblemStatement& problem) const {
  return problem.is_plane(reference_.axis) &&
         Turnings(problem).of_plane(problem.plane_of(reference_.axis)) < 0;
}

std::vector<SharedNormal> shared_normals(const ProblemStatement& problem) {
  return PlaneSides(problem).normals();
}

std::vector<DirectionsMadeOne> directions_made_one(const ProblemStatement& problem) {
  DisjointSets sets(problem.entity_count());
  std::vector<int> held(static_cast<std::size_t>(problem.entity_count()), -1);  // of the set with that root
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    if (is_held(problem, entity)) held[static_cast<std::size_t>(entity)] = entity;
  std::vector<DirectionsMadeOne> found;
  for (std::size_t i = 0; i < problem.relations.size(); ++i) {
    Relation one = problem.relations[i];
    if (const ConstraintKind* kind = find_kind(problem, one); kind == nullptr || !kind->shares_direction)
      continue;
    const int a = sets.find(one.of[0].entity), b = sets.find(one.of[1].entity);
    const int of_a = held[static_cast<std::size_t>(a)], of_b = held[static_cast<std::size_t>(b)];
    if (a != b && of_a >= 0 && of_b >= 0) found.push_back({{of_a, of_b}, static_cast<int>(i)});
    sets.join(a, b);
    held[static_cast<std::size_t>(sets.find(a))] = std::max(of_a, of_b);
  }
  return found;
}

std::vector<int> Turnings::turned_planes(const ProblemStatement& problem) {
  return PlaneSides(problem).numbers();
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
  DisjointSets sets(static_cast<int>(segments.size()));
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
