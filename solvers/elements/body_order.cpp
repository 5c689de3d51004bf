#include "solvers/elements/body_order.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "solvers/elements/body_joints.hpp"
#include "solvers/running/words.hpp"

namespace gcs {
namespace {

bool has(const std::vector<int>& all, int one) { return std::ranges::find(all, one) != all.end(); }

class Ordering {
 public:
  explicit Ordering(const ProblemStatement& problem)
      : problem_(problem), joints_(body_joints(problem)), is_placed_(problem.bodies.size()) {
    for (const BodyJoint& joint : joints_)
      if (!joint.is_known && order_.reason.empty()) order_.reason = why_unknown(joint);
  }

  BodyOrder run() {
    if (problem_.reference_body >= 0) take(problem_.reference_body);
    while (order_.reason.empty() && order_.steps.size() < is_placed_.size()) take(next());
    return std::move(order_);
  }

 private:
  bool is_placed(int body) const { return is_placed_[static_cast<std::size_t>(body)]; }
  const std::string& name(int body) const { return problem_.bodies[static_cast<std::size_t>(body)].name; }

  std::string why_unknown(const BodyJoint& joint) const {
    if (problem_.is_anchored() && joint.joins(problem_.reference_body))
      return fmt::format(
          "the given positions tell the pose of body '{}', and there are equations only where they are of "
          "all of its elements: give the others too",
          name(joint.other(problem_.reference_body)));
    std::vector<std::string> shared;
    for (const std::vector<int>& entities : {joint.points, joint.lines, joint.planes})
      for (const int entity : entities) shared.push_back(problem_.name(entity));
    return fmt::format("there are no equations yet for bodies that share {}, as '{}' and '{}' do",
                       enumeration(shared), name(joint.bodies[0]), name(joint.bodies[1]));
  }

  bool are_parallel(int body, const BodyDirection& a, const BodyDirection& b) const {
    return are_parallel_in_body(problem_, problem_.bodies[static_cast<std::size_t>(body)], a, b);
  }
  bool are_opposite(int body, const BodyDirection& a, const BodyDirection& b) const {
    const RigidBody& of = problem_.bodies[static_cast<std::size_t>(body)];
    return direction_in_body(problem_, of, a).dot(direction_in_body(problem_, of, b)) < 0;
  }

  /// The joints of a body with those before it.
  std::vector<const BodyJoint*> joints_before(int body) const {
    std::vector<const BodyJoint*> found;
    for (const BodyJoint& joint : joints_)
      if (joint.joins(body) && is_placed(joint.other(body))) found.push_back(&joint);
    return found;
  }

  bool has_direction(int body) const {
    return std::ranges::any_of(joints_, [&](const BodyJoint& joint) {
      return joint.shares_something() && !joint.directions.empty() && joint.joins(body) &&
             is_placed(joint.other(body));
    });
  }

  /// Whether it should not be the one that closes a loop.
  bool comes_first(int body) const {
    std::vector<BodyDirection> all;
    for (const BodyJoint& joint : joints_)
      for (const BodyJoint::Direction& direction : joint.directions) {
        if (!joint.joins(body) || direction.is_either_way) continue;
        const BodyDirection& in_body = joint.in_body(direction, body);
        for (const BodyDirection& other : all)
          if (are_parallel(body, in_body, other)) return true;
        all.push_back(in_body);
      }
    return all.size() > 2;
  }

  /// A point of bodies before it, the first in the body's order.
  std::optional<int> joint_point(int body) const {
    for (const BodyElement& element : problem_.bodies[static_cast<std::size_t>(body)].elements)
      if (problem_.is_point(element.entity) &&
          std::ranges::any_of(bodies_with(problem_, element.entity),
                              [&](int other) { return is_placed(other); }))
        return element.entity;
    return std::nullopt;
  }

  int next() const {
    int best = -1;
    const auto rank = [&](int body) {
      if (body < 0) return -1;
      if (!has_direction(body)) return joint_point(body) ? 1 : 0;
      return comes_first(body) ? 3 : 2;
    };
    for (int body = 0; body < static_cast<int>(is_placed_.size()); ++body)
      if (!is_placed(body) && rank(body) > rank(best)) best = body;
    return best;
  }

  void take(int body) {
    BodyStep step{body, {}, -1, {}, {}, {}};
    const std::vector<const BodyJoint*> before = joints_before(body);
    for (const bool is_either_way : {false, true})
      for (const BodyJoint* joint : before)
        for (const BodyJoint::Direction& direction : joint->directions)
          if (direction.is_either_way == is_either_way) add_known(*joint, direction, step);
    take_origin(step);
    imply(before, step);
    is_placed_[static_cast<std::size_t>(body)] = true;
    for (BodyJoint& joint : joints_)
      if (joint.joins(body) && !is_placed(joint.other(body)))
        for (BodyJoint::Direction& direction : joint.directions)
          if (!direction.is_either_way) give_axis(joint.in_body(direction, body), direction, step);
    order_.steps.push_back(std::move(step));
  }

  void add_known(const BodyJoint& joint, const BodyJoint::Direction& direction, BodyStep& step) {
    const BodyDirection& in_body = joint.in_body(direction, step.body);
    const auto same = std::ranges::find_if(
        step.known, [&](const BodyStep::Use& use) { return are_parallel(step.body, use.in_body, in_body); });
    const bool is_known = same != step.known.end();
    if (direction.is_either_way) {
      if (is_known || step.known.size() == 2) return;
      append(joint.lines, step.directed);
    } else if (is_known) {
      const bool is_opposite = same->is_opposite != are_opposite(step.body, same->in_body, in_body);
      if (direction.axis != same->axis || direction.is_opposite != is_opposite)
        refuse(step.body, "parallel hinges or planes");
      return;
    }
    const BodyDirection& before = joint.in_body(direction, joint.other(step.body));
    step.known.push_back({direction.axis, direction.is_opposite, in_body,
                          direction.is_either_way ? before.from : -1, direction.relation,
                          static_cast<int>(&joint - joints_.data())});
    if (step.known.size() > 2) refuse(step.body, "more than two hinges or planes");
  }

  void refuse(int body, const char* what) {
    order_.reason = fmt::format("body '{}' closes a loop with {}, for which there are no equations yet",
                                name(body), what);
  }

  void take_origin(BodyStep& step) const {
    for (const BodyStep::Use& use : step.known)
      if (const BodyJoint& joint = joints_[static_cast<std::size_t>(use.joint)];
          step.origin < 0 && !joint.points.empty())
        step.origin = joint.points[0];
    if (step.origin < 0) step.origin = joint_point(step.body).value_or(-1);
    for (const BodyStep::Use& use : step.known)
      if (const BodyJoint& joint = joints_[static_cast<std::size_t>(use.joint)];
          step.origin < 0 && !joint.lines.empty())
        step.origin = joint.lines[0];
  }

  /// What a point is on has its place with the point; of parallel planes all have with the first.
  void imply(const std::vector<const BodyJoint*>& before, BodyStep& step) const {
    if (step.origin >= 0) step.implied.push_back(step.origin);
    for (const BodyJoint* joint : before) {
      const bool has_point = !joint->points.empty(), is_turned = joint->directions.size() == 2;
      if (has_point) append(joint->lines, step.implied);
      if (has_point) append(joint->planes, step.implied);
      if (has_point && is_turned) append(joint->points, step.implied);
      if (!has_point && !is_turned && !joint->planes.empty())
        append({joint->planes.begin() + 1, joint->planes.end()}, step.implied);
      if (!joint->directions.empty() && !joint->directions[0].is_either_way)
        append(joint->lines, step.directed);
    }
    imply_hinges(before, step);
  }

  static void append(const std::vector<int>& more, std::vector<int>& entities) {
    entities.insert(entities.end(), more.begin(), more.end());
  }

  /// Of hinges that have one such point, all; of the others all but the first, which is joined by equations.
  void imply_hinges(const std::vector<const BodyJoint*>& before, BodyStep& step) const {
    std::vector<const BodyJoint*> left;
    for (const BodyJoint* joint : before)
      if (joint->points.size() > 1) left.push_back(joint);
    std::vector<int> joined{step.origin};
    const auto is_met = [&](const BodyJoint* joint) {
      return std::ranges::any_of(joint->points,
                                 [&](int point) { return has(step.implied, point) || has(joined, point); });
    };
    while (!left.empty()) {
      auto joint = std::ranges::find_if(left, is_met);
      if (joint == left.end()) {
        joint = left.begin();
        joined.push_back((*joint)->points[0]);
      }
      for (const int point : (*joint)->points)
        if (!has(joined, point)) step.implied.push_back(point);
      left.erase(joint);
    }
  }

  /// That of a joint of the body with the same direction, or a new one.
  void give_axis(const BodyDirection& in_body, BodyJoint::Direction& direction, BodyStep& step) {
    const auto take_over = [&](const BodyDirection& known, int axis, bool is_opposite) {
      if (!are_parallel(step.body, known, in_body)) return false;
      direction.axis = axis;
      direction.is_opposite = is_opposite != are_opposite(step.body, known, in_body);
      return true;
    };
    for (const BodyStep::Use& use : step.known)
      if (use.along < 0 && take_over(use.in_body, use.axis, use.is_opposite)) return;
    for (const int axis : step.further)
      if (take_over(order_.axes[static_cast<std::size_t>(axis)], axis, false)) return;
    direction.axis = static_cast<int>(order_.axes.size());
    order_.axes.push_back(in_body);
    step.further.push_back(direction.axis);
  }

  const ProblemStatement& problem_;
  std::vector<BodyJoint> joints_;
  std::vector<bool> is_placed_;
  BodyOrder order_;
};

}  // namespace

BodyOrder body_order(const ProblemStatement& problem) { return Ordering(problem).run(); }

}  // namespace gcs
