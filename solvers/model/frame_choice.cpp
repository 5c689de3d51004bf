#include "solvers/model/frame_choice.hpp"

#include <algorithm>
#include <utility>

#include "solvers/model/point_reference.hpp"

namespace gcs {
namespace {

/// Whether a constraint of that type is between these two.
bool is_stated(const ProblemStatement& problem, const std::string& type, int a, int b) {
  return std::ranges::any_of(problem.relations, [&](const Relation& relation) {
    return relation.type == type && relation.of.size() == 2 &&
           ((relation.of[0] == Operand{a} && relation.of[1] == Operand{b}) ||
            (relation.of[0] == Operand{b} && relation.of[1] == Operand{a}));
  });
}

/// Whether a constraint gives both one direction.
bool are_aligned(const ProblemStatement& problem, int a, int b) {
  return is_stated(problem, problem.is_line(a) == problem.is_line(b) ? "parallel" : "perpendicular", a, b);
}

/// Points but the origin, lines, and planes: those that no constraint gives the direction of a plane.
std::vector<int> frame_directions(const ProblemStatement& problem, int origin) {
  std::vector<int> found;
  for (int entity = 0; entity < problem.entity_count(); ++entity) {
    bool is_free = entity != origin;
    for (int other = problem.line_entity(0); !problem.is_point(entity) && other < problem.entity_count();
         ++other)
      if (problem.is_plane(entity) || problem.is_plane(other))
        is_free = is_free && !are_aligned(problem, entity, other);
    if (is_free) found.push_back(entity);
  }
  return found;
}

/// See Reference; −1 for what the scene does not have.
Reference element_reference(const ProblemStatement& problem) {
  Reference reference;
  if (!problem.points.empty()) reference.origin = 0;
  const std::vector<int> directions = frame_directions(problem, reference.origin);
  if (directions.empty()) return reference;
  reference.axis = directions.front();
  if (problem.dimension == 2 && reference.origin >= 0) return reference;
  for (const int entity : directions) {
    if (entity == reference.axis || are_aligned(problem, reference.axis, entity)) continue;
    if (reference.plane < 0) {
      reference.plane = entity;
      continue;
    }
    if (reference.origin < 0 && problem.is_plane(reference.axis)) reference.height = entity;
    break;
  }
  return reference;
}

/// Whether a constraint puts a point on the line that is the axis, or on that of origin and axis.
bool is_on_axis(const ProblemStatement& problem, const Reference& reference, int point) {
  return std::ranges::any_of(problem.relations, [&](const Relation& relation) {
    const auto names = [&](int entity) {
      return entity >= 0 && std::ranges::find(relation.of, Operand{entity}) != relation.of.end();
    };
    return names(point) && names(reference.axis) &&
           ((relation.type == "on" && problem.is_line(reference.axis)) ||
            (relation.type == "collinear" && names(reference.origin)));
  });
}

/// Elements by which the motions that given ones leave can be used up, those first that a distance joins with these.
class Completion {
 public:
  Completion(const ProblemStatement& problem, const GivenAxis& given)
      : problem_(problem),
        given_(given),
        reference_{given.origin, given.axis},
        free_(frame_directions(problem, given.origin)) {
    std::erase_if(
        free_, [&](int entity) { return problem.is_fixed(entity) || !bodies_with(problem, entity).empty(); });
    std::stable_partition(free_.begin(), free_.end(), [&](int entity) { return is_near(entity); });
  }

  std::optional<Reference> run() {
    if (given_.leaves_shift() || given_.leaves_turn_about_line()) return beside_all_given();
    if (reference_.axis < 0) reference_.axis = next(any);
    if (reference_.axis < 0) return std::nullopt;
    if (problem_.dimension == 2 && reference_.origin >= 0) return reference_;
    const bool is_plane_alone = reference_.origin < 0 && problem_.is_plane(reference_.axis);
    if (is_plane_alone) reference_.height = next(point);
    reference_.plane = next(any);
    if (is_plane_alone && reference_.height < 0 && reference_.plane >= 0 &&
        problem_.is_plane(reference_.plane)) {
      reference_.height = next(any);
      if (reference_.height < 0) return std::nullopt;
    }
    return reference_.plane < 0 ? std::nullopt : std::optional(reference_);
  }

 private:
  enum Kind { any, point };

  std::optional<Reference> beside_all_given() {
    Reference reference;
    (given_.leaves_shift() ? reference.height : reference.plane) = next(any);
    if (reference.height < 0 && reference.plane < 0) return std::nullopt;
    return reference;
  }

  bool is_near(int entity) const {
    return std::ranges::any_of(problem_.constraints, [&](const DistanceConstraint& c) {
      return (c.between[0] == entity && problem_.is_fixed(c.between[1])) ||
             (c.between[1] == entity && problem_.is_fixed(c.between[0]));
    });
  }

  /// Whether a constraint with a given element lets the shift, or the turn about an axis, leave an element where it is.
  bool is_held_by(int given, int entity) const {
    if (given_.leaves_shift())
      return is_stated(problem_, "parallel", given, entity) &&
             !(problem_.is_line(entity) && problem_.is_plane(given));
    return are_aligned(problem_, given, entity) ||
           (problem_.is_line(given) && is_stated(problem_, "on", given, entity));
  }

  bool is_moved(int entity) const {
    for (int given = 0; given < problem_.entity_count(); ++given)
      if (problem_.is_fixed(given) && is_held_by(given, entity)) return false;
    return !are_aligned(problem_, reference_.axis, entity) && !is_on_axis(problem_, reference_, entity);
  }

  int next(Kind kind) {
    const auto found = std::ranges::find_if(
        free_, [&](int entity) { return (kind == any || problem_.is_point(entity)) && is_moved(entity); });
    if (found == free_.end()) return -1;
    const int entity = *found;
    free_.erase(found);
    return entity;
  }

  const ProblemStatement& problem_;
  GivenAxis given_;
  Reference reference_;
  std::vector<int> free_;
};

}  // namespace

Reference default_reference(const ProblemStatement& problem) {
  if (!problem.is_general())
    return problem.lines.empty() ? point_reference(problem) : line_reference(problem);
  return static_cast<int>(problem.points.size()) < problem.dimension ? element_reference(problem)
                                                                     : point_reference(problem);
}

Reference line_reference(const ProblemStatement& problem) {
  Reference reference;
  reference.line = 0;
  const int line = static_cast<int>(problem.points.size());
  for (const DistanceConstraint& c : problem.constraints)
    if (c.between[0] == line || c.between[1] == line) {
      const int point = c.between[0] == line ? c.between[1] : c.between[0];
      if (reference.height < 0 || c.length() > 0) reference.height = point;
      if (c.length() > 0) break;
    }
  return reference;
}

bool rests_in_frame(const ProblemStatement& problem, int entity) {
  if (!problem.is_fixed(entity)) return false;
  if (!problem.file_frame || problem.reference_body >= 0) return true;
  for (int other = 0; other < problem.entity_count(); ++other)
    if (other != entity && problem.is_fixed(other)) return true;
  const Reference& frame = *problem.reference;
  return problem.is_point(entity) ? frame.origin == entity : frame.origin < 0 && frame.axis == entity;
}

std::optional<Reference> completing_reference(const ProblemStatement& problem, const GivenAxis& given) {
  return Completion(problem, given).run();
}

bool is_zero_in_frame(const ProblemStatement& problem, const Reference& reference, int point, int axis) {
  if (point == reference.origin) return true;
  if (point == reference.axis) return axis > 0;
  if (point == reference.plane) {
    const bool is_beside_line = reference.origin < 0 && problem.is_line(reference.axis);
    return axis > 1 || (axis == 0 && is_beside_line);
  }
  return point == reference.height && (reference.axis < 0 ? axis == 0 : axis > 0);
}

}  // namespace gcs
