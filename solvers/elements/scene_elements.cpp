#include "solvers/elements/scene_elements.hpp"

#include <algorithm>
#include <set>

#include "solvers/elements/body_joints.hpp"
#include "solvers/elements/body_motion.hpp"
#include "solvers/elements/body_order.hpp"
#include "solvers/elements/body_placing.hpp"
#include "solvers/elements/element_kinds.hpp"
#include "solvers/elements/exact_coordinates.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/elements/pose_features.hpp"
#include "solvers/elements/scene_frame.hpp"
#include "solvers/model/frame_choice.hpp"
#include "solvers/numeric/bilinear_product.hpp"

namespace gcs {
namespace {

class Placing {
 public:
  explicit Placing(SystemBuilder& builder)
      : builder_(builder),
        with_given_(with_given_body(builder.problem())),
        has_point_(problem().points.size()),
        has_line_(problem().lines.size()),
        has_plane_(problem().planes.size()) {}

  void run() {
    place_bodies();
    state_directions();
    place_frame();
    place_points();
    place_planes();
    place_lines();
  }

 private:
  static std::size_t index(int number) { return static_cast<std::size_t>(number); }
  const ProblemStatement& problem() const { return builder_.problem(); }

  void place_bodies() {
    const BodyOrder order = body_order(with_given_);
    std::vector<VectorForm> axes(order.axes.size());
    for (const BodyStep& step : order.steps) {
      if (with_given_.bodies[index(step.body)].elements.empty()) continue;
      builder_.begin(owner_of_joints(step.body));
      const PlacedBody body = placed(step, order, axes);
      for (std::size_t i = 0; i < step.further.size(); ++i) axes[index(step.further[i])] = body.directions[i];
      place(body, step);
      builder_.begin(no_value);
    }
  }

  PlacedBody placed(const BodyStep& step, const BodyOrder& order, const std::vector<VectorForm>& axes) {
    const RigidBody& body = with_given_.bodies[index(step.body)];
    std::vector<BodyDirection> further;
    for (const int axis : step.further) further.push_back(order.axes[index(axis)]);
    if (step.body == with_given_.reference_body) return body_at_rest(builder_, body, further);
    if (step.known.empty())
      return free_body(builder_, body, step.origin < 0 ? std::nullopt : std::optional(step.origin), further);
    const auto known = [&](const BodyStep::Use& use) {
      if (use.along >= 0) return HingedPose::Axis{use.in_body, direction_along(use, step.body)};
      const VectorForm& axis = axes[index(use.axis)];
      return HingedPose::Axis{use.in_body, use.is_opposite ? negated(axis) : axis};
    };
    HingedPose pose;
    pose.first = known(step.known[0]);
    if (step.known.size() > 1) pose.second = known(step.known[1]);
    pose.is_turned = step.is_turned();
    pose.origin = step.origin < 0 ? body_vectors(problem(), body, 0).origin : step.origin;
    pose.at = origin_of(pose, body);
    return hinged_body(builder_, body, pose, further);
  }

  /// One of the body that is another one or its opposite.
  VectorForm direction_along(const BodyStep::Use& use, int number) {
    const RigidBody& body = with_given_.bodies[index(number)];
    const VectorForm own = builder_.vector();
    builder_.name({body.name + "_" + problem().name(use.in_body.from) + "_u", own});
    const VectorForm other = direction_of(use.along);
    builder_.define([features = features_of(body), d = builder_.dimension(), other,
                     given = direction_in_body(with_given_, body, use.in_body)](const Placement& at,
                                                                                const ComplexValues&) {
      ComplexValues values = components(body_pose(features, at, d).axes * given, d);
      for (std::size_t i = 0; i < values.size(); ++i)
        if (is_zero(other[i])) values[i] = 0;  // without rounding, which no other term is larger than
      return values;
    });
    builder_.add(Equation().plus(own, own).equals(exactly(1)));
    if (use.relation >= 0) builder_.begin(owner_of_relation(use.relation));
    state_same_direction(builder_, own, other);
    builder_.begin(owner_of_joints(number));
    stated_.insert(use.relation);
    return own;
  }

  int owner_of_relation(int relation) const { return builder_.scene().constraint_count() + relation; }

  /// Of lines and planes that have theirs.
  void state_directions() {
    for (const DirectionsMadeOne& made : directions_made_one(problem())) {
      if (stated_.contains(made.relation)) continue;
      builder_.begin(owner_of_relation(made.relation));
      state_same_direction(builder_, direction_of(made.entities[0]), direction_of(made.entities[1]));
    }
    builder_.begin(no_value);
  }

  VectorForm direction_of(int entity) const {
    return problem().is_line(entity) ? builder_.line(entity).direction : builder_.plane(entity).normal;
  }

  /// The place of a point that has one or, on a line that has one, of the body's point of that, or else of any. On the line
  /// it slides along the body's own direction, about which it turns, also where that is not quite the line's.
  VectorForm origin_of(const HingedPose& pose, const RigidBody& body) {
    const int entity = pose.origin;
    if (problem().is_point(entity) && has_point_[index(entity)]) return builder_.point(entity);
    const VectorForm at = builder_.vector();
    builder_.name({body.name + "_t", at});
    if (problem().is_point(entity)) {
      builder_.define([entity, d = builder_.dimension()](const Placement& placement, const ComplexValues&) {
        return components(placement.points.col(entity), d);
      });
      return at;
    }
    const bool is_first = are_parallel_in_body(problem(), body, {entity}, pose.first.in_body);
    const LineForms line{builder_.line(entity).foot,
                         is_first ? pose.first.direction : pose.second->direction};
    const ElementPosition position =
        position_in_body(problem(), element_of(body, entity), -builder_.scene().unit_exponent());
    builder_.define([features = features_of(body), line, given = std::get<LinePosition>(position).point](
                        const Placement& placement, const ComplexValues& x) {
      const BodyPose there = body_pose(features, placement, 3);
      const Eigen::Vector3cd foot = vector_at(line.foot, x), along = vector_at(line.direction, x);
      const Eigen::Vector3cd way = there.origin + there.axes * given - foot;
      return components(foot + bilinear_product(way, along) * along, 3);
    });
    state_on_line(builder_, at, line);
    return at;
  }

  PoseFeatures features_of(const RigidBody& body) const {
    return pose_features(problem(), body, -builder_.scene().unit_exponent());
  }

  /// What was in a body before closes a loop, unless it is there anyway.
  void place(const PlacedBody& body, const BodyStep& step) {
    const auto has = [](const std::vector<int>& entities, int entity) {
      return std::ranges::find(entities, entity) != entities.end();
    };
    for (const BodyPoint& placed : body.points) {
      if (has_point_[index(placed.point)]) {
        if (!has(step.implied, placed.point)) join(placed.at, builder_.point(placed.point));
        continue;
      }
      if (!placed.numbers.empty()) builder_.put_arm(placed);
      builder_.put_point(placed.point, placed.at);
      has_point_[index(placed.point)] = true;
    }
    for (const BodySegment& segment : body.segments) builder_.put_segment(segment);
    for (const auto& [line, at] : body.lines) {
      const int entity = problem().line_entity(line);
      if (has_line_[index(line)]) {
        if (!has(step.directed, entity))
          state_same_direction(builder_, at.direction, builder_.line(entity).direction);
        if (!has(step.implied, entity)) state_on_line(builder_, at.foot, builder_.line(entity), gap_value);
        continue;
      }
      builder_.put_line(line, at);
      has_line_[index(line)] = true;
    }
    for (const auto& [plane, at] : body.planes) {
      const int entity = problem().plane_entity(plane);
      if (has_plane_[index(plane)]) {
        if (!has(step.implied, entity)) join(at, entity, body.points.front(), step.body);
        continue;
      }
      builder_.put_plane(plane, at);
      has_plane_[index(plane)] = true;
    }
  }

  /// n·p − h is as in the body, for a point p of it.
  void join(const PlaneForms& plane, int entity, const BodyPoint& point, int number) {
    const RigidBody& body = with_given_.bodies[index(number)];
    const int exponent = -builder_.scene().unit_exponent();
    const ExactNumber offset = offset_from(rational_vector(element_of(body, point.point), 0, 3, exponent),
                                           element_of(body, entity), exponent);
    builder_.add(Equation()
                     .plus(plane.normal, point.at)
                     .plus(constant_form(offset))
                     .minus(builder_.plane(entity).offset)
                     .equals(),
                 gap_value);
  }

  /// Components that are 0 in both are no equations.
  void join(const VectorForm& a, const VectorForm& b) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (is_zero(a[axis]) && is_zero(b[axis])) continue;
      Equation gap;
      add_terms(a[axis], gap);
      add_terms(negated(b[axis]), gap);
      builder_.add(gap.equals(), gap_value);
    }
  }

  /// One by one, since the rounding of a long chain is relative to its terms, also where they add up to 0.
  static void add_terms(const LinearForm& form, Equation& equation) {
    for (const ScaledUnknown& term : form.terms) equation.plus(LinearForm{{term}, {}});
    equation.plus(constant_form(form.constant));
  }

  /// Lines and planes that the frame is put in.
  void place_frame() {
    const Reference& frame = builder_.frame().reference();
    for (const int entity : {frame.axis, frame.plane, frame.height}) {
      if (entity < 0 || problem().is_point(entity) || rests_in_frame(problem(), entity)) continue;
      if (problem().is_line(entity)) {
        builder_.put_line(problem().line_of(entity), line_in_frame(entity));
        has_line_[index(problem().line_of(entity))] = true;
      } else {
        builder_.put_plane(problem().plane_of(entity), plane_in_frame(entity));
        has_plane_[index(problem().plane_of(entity))] = true;
      }
    }
  }

  /// Of length 1: along the first axis, or in the plane of the first two, or any.
  VectorForm direction_in_frame(int entity, SignMask turning,
                                const std::function<ComplexValues(const Placement&)>& where) {
    const SceneFrame& frame = builder_.frame();
    VectorForm direction;
    if (entity == frame.reference().axis) {
      direction[0] = constant_form(exactly(1));
      return direction;
    }
    const int count = entity == frame.reference().plane ? 2 : builder_.dimension();
    for (int axis = 0; axis < count; ++axis)
      direction[index(axis)] = builder_.unknown(frame.axis(axis) ^ turning);
    builder_.define([where, count](const Placement& at, const ComplexValues&) {
      ComplexValues values = where(at);
      values.resize(index(count));
      return values;
    });
    builder_.add(Equation().plus(direction, direction).equals(exactly(1)));
    return direction;
  }

  /// Without a point as the origin the first line goes through it, and the second through a point of the third axis or,
  /// beside a plane, through the origin. Beside given elements that leave a shift its foot has no first coordinate.
  LineForms line_in_frame(int entity) {
    const SceneFrame& frame = builder_.frame();
    const int first = frame.reference().axis;
    const bool is_first = entity == first, passes = frame.puts_through_origin(entity);
    const int line = problem().line_of(entity);
    LineForms forms;
    forms.turning = is_first ? frame.axis(0) : builder_.new_turning();
    forms.direction = direction_in_frame(entity, forms.turning, [line](const Placement& at) {
      return components(at.lines[index(line)].direction, 3);
    });
    for (int axis = 0; axis < builder_.dimension(); ++axis) {
      const bool is_beside_line = !is_first && problem().is_line(first);
      const bool is_there = passes ? is_beside_line && axis == 2
                                   : axis > 0 || (!is_first && entity != frame.reference().height);
      if (!is_there) continue;
      forms.foot[index(axis)] = builder_.unknown(frame.axis(axis));
      builder_.define([line, axis](const Placement& at, const ComplexValues&) {
        return ComplexValues{at.lines[index(line)].point[axis]};
      });
    }
    if (!passes && !is_first) builder_.add(Equation().plus(forms.foot, forms.direction).equals());
    return forms;
  }

  PlaneForms plane_in_frame(int entity) {
    const int plane = problem().plane_of(entity);
    const SignMask turning = builder_.turning_of_plane(plane);
    const VectorForm normal = direction_in_frame(entity, turning, [plane](const Placement& at) {
      return components(at.planes[index(plane)].normal, 3);
    });
    if (builder_.frame().puts_through_origin(entity)) return {normal, {}, turning};
    return plane_across(builder_, normal, turning, false, plane);
  }

  void place_points() {
    for (int point = 0; point < static_cast<int>(has_point_.size()); ++point) {
      if (has_point_[index(point)]) continue;
      VectorForm at;
      for (int axis = 0; axis < builder_.dimension(); ++axis) at[index(axis)] = coordinate(point, axis);
      builder_.put_point(point, at);
    }
  }

  LinearForm coordinate(int point, int axis) {
    if (is_zero_in_frame(problem(), builder_.frame().reference(), point, axis)) return {};
    const LinearForm form = builder_.unknown(builder_.frame().axis(axis));
    builder_.define([point, axis](const Placement& at, const ComplexValues&) {
      return ComplexValues{at.points(axis, point)};
    });
    return form;
  }

  void place_planes() {
    const std::vector<SharedNormal> normals = shared_normals(problem());
    for (const bool is_leader : {true, false})
      for (int plane = 0; plane < static_cast<int>(has_plane_.size()); ++plane)
        if (!has_plane_[index(plane)] && (normals[index(plane)].leader < 0) == is_leader)
          builder_.put_plane(plane, placed(plane, normals[index(plane)]));
  }

  PlaneForms placed(int plane, const SharedNormal& normal) {
    if (normal.leader < 0)
      return free_plane(builder_, builder_.turning_of_plane(plane),
                        [plane](const Placement& at) { return at.planes[index(plane)]; });
    if (problem().is_line(normal.leader)) {
      const LineForms line = builder_.line(normal.leader);
      return plane_across(builder_, line.direction, line.turning, normal.is_either_way, plane);
    }
    const PlaneForms other = builder_.plane(normal.leader);
    return plane_across(builder_, other.normal, other.turning, normal.is_either_way, plane);
  }

  /// Lines of bodies first, since those that are parallel to them have their directions.
  void place_lines() {
    for (const bool is_of_body : {true, false})
      for (int line = 0; line < static_cast<int>(has_line_.size()); ++line)
        if (has_line_[index(line)] == is_of_body) place_with_parallels(line);
  }

  void place_with_parallels(int line) {
    const std::vector<int> parallel = parallel_lines(problem(), line);
    const bool is_there = has_line_[index(line)];
    if (!is_there) builder_.put_line(line, first_line(line, parallel));
    has_line_[index(line)] = true;
    const LineForms& first = builder_.line(problem().line_entity(line));
    const VectorForm direction = first.direction;
    const SignMask turning = first.turning;
    for (const int other : parallel) {
      if (has_line_[index(other)]) continue;
      builder_.put_line(other, line_along(builder_, direction, turning, other));
      has_line_[index(other)] = true;
    }
  }

  LineForms first_line(int line, const std::vector<int>& parallel) {
    const std::vector<int> across = planes_across(problem(), parallel);
    if (across.empty())
      return free_line(builder_, builder_.new_turning(),
                       [line](const Placement& at) { return at.lines[index(line)]; });
    const PlaneForms plane = builder_.plane(problem().plane_entity(across.front()));
    return line_along(builder_, plane.normal, plane.turning, line);
  }

  SystemBuilder& builder_;
  ProblemStatement with_given_;
  std::vector<bool> has_point_, has_line_, has_plane_;
  std::set<int> stated_;  // relations that give a body a direction
};

}  // namespace

void place_elements(SystemBuilder& builder) { Placing(builder).run(); }

}  // namespace gcs
