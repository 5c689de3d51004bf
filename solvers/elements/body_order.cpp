#include "solvers/elements/body_order.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "solvers/elements/body_motion.hpp"

namespace gcs {
namespace {

/// Below this sine directions are parallel: positions in two bodies agree as well, of the scene's size.
constexpr double parallel_sine = 1e-9;

struct Hinge {
  std::array<int, 2> bodies{};
  std::vector<int> points;  ///< in the order of the first body; two at least
  int axis = -1;            ///< once a body has given it
  bool is_opposite = false;

  bool joins(int body) const { return bodies[0] == body || bodies[1] == body; }
  int other(int body) const { return bodies[0] == body ? bodies[1] : bodies[0]; }
  BodyDirection direction() const { return {points[0], points[1]}; }
  bool has(const std::vector<int>& some) const {
    return std::ranges::find_first_of(points, some) != points.end();
  }
};

bool has(const std::vector<int>& all, int one) { return std::ranges::find(all, one) != all.end(); }

std::vector<int> shared_points(const ProblemStatement& problem, const RigidBody& a, const RigidBody& b) {
  std::vector<int> points;
  for (const BodyElement& element : a.elements)
    if (problem.is_point(element.entity) &&
        std::ranges::find(b.elements, element.entity, &BodyElement::entity) != b.elements.end())
      points.push_back(element.entity);
  return points;
}

std::vector<Hinge> hinges_of(const ProblemStatement& problem) {
  std::vector<Hinge> hinges;
  const int bodies = static_cast<int>(problem.bodies.size());
  for (int a = 0; a < bodies && problem.dimension == 3; ++a)
    for (int b = a + 1; b < bodies; ++b) {
      std::vector<int> points = shared_points(problem, problem.bodies[static_cast<std::size_t>(a)],
                                              problem.bodies[static_cast<std::size_t>(b)]);
      if (points.size() >= 2) hinges.push_back({{a, b}, std::move(points)});
    }
  return hinges;
}

class Ordering {
 public:
  explicit Ordering(const ProblemStatement& problem)
      : problem_(problem), hinges_(hinges_of(problem)), is_placed_(problem.bodies.size()) {}

  BodyOrder run() {
    if (problem_.reference_body >= 0) take(problem_.reference_body);
    while (order_.reason.empty() && order_.steps.size() < is_placed_.size()) take(next());
    return std::move(order_);
  }

 private:
  bool is_placed(int body) const { return is_placed_[static_cast<std::size_t>(body)]; }

  Eigen::Vector3d vector(int body, const BodyDirection& direction) const {
    const RigidBody& of = problem_.bodies[static_cast<std::size_t>(body)];
    const auto at = [&](int entity) {
      return std::get<Eigen::Vector3d>(
          position_in_body(problem_, *std::ranges::find(of.elements, entity, &BodyElement::entity)));
    };
    return (at(direction.to) - at(direction.from)).stableNormalized();
  }

  bool are_parallel(int body, const BodyDirection& a, const BodyDirection& b) const {
    return vector(body, a).cross(vector(body, b)).norm() <= parallel_sine;
  }
  bool are_opposite(int body, const BodyDirection& a, const BodyDirection& b) const {
    return vector(body, a).dot(vector(body, b)) < 0;
  }

  bool is_hinged_to_placed(int body) const {
    return std::ranges::any_of(
        hinges_, [&](const Hinge& hinge) { return hinge.joins(body) && is_placed(hinge.other(body)); });
  }

  /// Whether it should not be the one that closes a loop.
  bool comes_first(int body) const {
    std::vector<BodyDirection> all;
    for (const Hinge& hinge : hinges_) {
      if (!hinge.joins(body)) continue;
      for (const BodyDirection& other : all)
        if (are_parallel(body, hinge.direction(), other)) return true;
      all.push_back(hinge.direction());
    }
    return all.size() > 2;
  }

  std::optional<int> joint(int body) const {
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
      if (!is_hinged_to_placed(body)) return joint(body) ? 1 : 0;
      return comes_first(body) ? 3 : 2;
    };
    for (int body = 0; body < static_cast<int>(is_placed_.size()); ++body)
      if (!is_placed(body) && rank(body) > rank(best)) best = body;
    return best;
  }

  /// Whether points that it shares with a body before it tell its pose.
  bool is_held(int body) const {
    const auto by = [&](int other) {
      const std::vector<int> points = shared_points(problem_, problem_.bodies[static_cast<std::size_t>(body)],
                                                    problem_.bodies[static_cast<std::size_t>(other)]);
      return points.size() >= 2 && (problem_.dimension == 2 ||
                                    std::ranges::any_of(points.begin() + 2, points.end(), [&](int point) {
                                      return !are_parallel(body, {points[0], points[1]}, {points[0], point});
                                    }));
    };
    for (int other = 0; other < static_cast<int>(is_placed_.size()); ++other)
      if (is_placed(other) && by(other)) return true;
    return false;
  }

  void take(int body) {
    if (is_held(body))
      order_.reason = fmt::format(
          "the given positions tell the pose of body '{}', and there are equations only where they are of "
          "all of "
          "its elements: give the others too",
          problem_.bodies[static_cast<std::size_t>(body)].name);
    BodyStep step{body, {}, -1, {}, {}};
    for (const Hinge& hinge : hinges_)
      if (hinge.joins(body) && is_placed(hinge.other(body))) add_known(hinge, step);
    if (step.known.empty())
      take_joint(step);
    else
      step.implied = implied_points(step);
    is_placed_[static_cast<std::size_t>(body)] = true;
    for (Hinge& hinge : hinges_)
      if (hinge.joins(body) && !is_placed(hinge.other(body))) give_axis(hinge, step);
    order_.steps.push_back(std::move(step));
  }

  void take_joint(BodyStep& step) const {
    const std::optional<int> point = joint(step.body);
    if (!point) return;
    step.origin = *point;
    step.implied = {*point};
  }

  void add_known(const Hinge& hinge, BodyStep& step) {
    const auto same = std::ranges::find_if(step.known, [&](const BodyStep::Use& use) {
      return are_parallel(step.body, use.in_body, hinge.direction());
    });
    if (same == step.known.end()) {
      if (step.known.empty()) step.origin = hinge.points[0];
      step.known.push_back({hinge.axis, hinge.is_opposite, hinge.direction()});
      if (step.known.size() > 2) refuse(step.body, "more than two hinges");
      return;
    }
    const bool is_opposite = same->is_opposite != are_opposite(step.body, same->in_body, hinge.direction());
    if (hinge.axis != same->axis || hinge.is_opposite != is_opposite) refuse(step.body, "parallel hinges");
  }

  void refuse(int body, const char* what) {
    order_.reason = fmt::format("body '{}' closes a loop with {}, for which there are no equations yet",
                                problem_.bodies[static_cast<std::size_t>(body)].name, what);
  }

  /// Of hinges that have one such point, all; of the others all but the first, which is joined by equations.
  std::vector<int> implied_points(const BodyStep& step) const {
    std::vector<const Hinge*> left;
    for (const Hinge& hinge : hinges_)
      if (hinge.joins(step.body) && is_placed(hinge.other(step.body))) left.push_back(&hinge);
    std::vector<int> implied, joined{step.origin};
    while (!left.empty()) {
      auto hinge =
          std::ranges::find_if(left, [&](const Hinge* h) { return h->has(implied) || h->has(joined); });
      if (hinge == left.end()) {
        hinge = left.begin();
        joined.push_back((*hinge)->points[0]);
      }
      for (const int point : (*hinge)->points)
        if (point == step.origin || !has(joined, point)) implied.push_back(point);
      left.erase(hinge);
    }
    return implied;
  }

  /// That of a hinge of the body with the same direction, or a new one.
  void give_axis(Hinge& hinge, BodyStep& step) {
    const auto take_over = [&](const BodyDirection& in_body, int axis, bool is_opposite) {
      if (!are_parallel(step.body, in_body, hinge.direction())) return false;
      hinge.axis = axis;
      hinge.is_opposite = is_opposite != are_opposite(step.body, in_body, hinge.direction());
      return true;
    };
    for (const BodyStep::Use& use : step.known)
      if (take_over(use.in_body, use.axis, use.is_opposite)) return;
    for (const int axis : step.further)
      if (take_over(order_.axes[static_cast<std::size_t>(axis)], axis, false)) return;
    hinge.axis = static_cast<int>(order_.axes.size());
    order_.axes.push_back(hinge.direction());
    step.further.push_back(hinge.axis);
  }

  const ProblemStatement& problem_;
  std::vector<Hinge> hinges_;
  std::vector<bool> is_placed_;
  BodyOrder order_;
};

}  // namespace

BodyOrder body_order(const ProblemStatement& problem) { return Ordering(problem).run(); }

}  // namespace gcs
