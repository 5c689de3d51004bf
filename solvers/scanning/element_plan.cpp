#include "solvers/scanning/element_plan.hpp"

#include <algorithm>
#include <cstddef>
#include <numbers>
#include <utility>

#include "solvers/elements/scene_system.hpp"
#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

using std::numbers::pi;

/// Planes that cut the sphere of a step in points.
constexpr int enough_cuts = 2;

/// The value of a relation that a plan can build on.
std::optional<double> value_of(const Scene& scene, const Relation& relation) {
  const ProblemStatement& problem = scene.problem();
  if (relation.of.size() != 2 || relation.of[0].is_segment() || relation.of[1].is_segment())
    return std::nullopt;
  const int a = relation.of[0].entity, b = relation.of[1].entity;
  if (problem.is_line(a) || problem.is_line(b)) return std::nullopt;
  const bool is_of_planes = problem.is_plane(a) && problem.is_plane(b);
  const bool is_beside_plane = problem.is_plane(a) != problem.is_plane(b);
  if (relation.type == "angle" && is_of_planes)
    return rounded_to_double(given_cosine(relation, false)).real();
  if (relation.type == "distance" && is_beside_plane)
    return rounded_to_double(given_length(scene, relation.given)).real();
  if ((relation.type == "perpendicular" && is_of_planes) || (relation.type == "on" && is_beside_plane))
    return 0.0;
  return std::nullopt;
}

std::vector<ElementPair> pairs_of(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  std::vector<ElementPair> pairs;
  for (std::size_t c = 0; c < problem.constraints.size(); ++c) {
    const auto [a, b] = problem.constraints[c].between;
    if (problem.is_point(a) && problem.is_point(b)) pairs.push_back({{a, b}, scene.target_lengths()[c]});
  }
  for (const Relation& relation : problem.relations)
    if (const auto value = value_of(scene, relation))
      pairs.push_back({{relation.of[0].entity, relation.of[1].entity}, *value});
  return pairs;
}

/// Places elements one after the other.
class Placing {
 public:
  explicit Placing(const Scene& scene)
      : scene_(&scene), pairs_(pairs_of(scene)), placed_(static_cast<std::size_t>(problem().entity_count())) {
    for (int p = 0; p < scene.point_count(); ++p)
      if (scene.fixed_point(p)) placed_[static_cast<std::size_t>(p)] = true;
  }

  void place_origin(int point) {
    ElementStep step;
    step.place = point;
    step.is_origin = true;
    append(std::move(step));
  }
  /// False where no instruction places the element.
  bool place(int element) {
    if (auto step = step_of(element)) {
      append(*std::move(step));
      return true;
    }
    return false;
  }
  /// Goes on as long as some instruction places an element, with the one of the fewest angles.
  void place_all() {
    for (;;) {
      std::optional<ElementStep> next;
      for (int element = 0; element < problem().entity_count(); ++element) {
        auto step = step_of(element);
        if (step && (!next || step->angles < next->angles)) next = std::move(step);
      }
      if (!next) return;
      append(*std::move(next));
    }
  }

  const ElementPlan& plan() const { return plan_; }
  /// The first element that is not placed; −1: none.
  int missing() const {
    const auto open = std::ranges::find(placed_, false);
    return open == placed_.end() ? -1 : static_cast<int>(open - placed_.begin());
  }

 private:
  const ProblemStatement& problem() const { return scene_->problem(); }
  bool is_placed(int element) const { return placed_[static_cast<std::size_t>(element)]; }

  /// Zeros and the sign by which the frame places the point that comes next.
  void take_frame(ElementStep& step) const {
    const auto before = static_cast<int>(plan_.steps.size());
    const bool has_frame = !scene_->is_anchored() && before < scene_->dimension();
    if (has_frame) {
      step.positive = before - 1;
      for (int axis = before; axis < scene_->dimension(); ++axis) step.zeros.push_back(axis);
    }
    if (scene_->dimension() == 2) step.zeros.push_back(2);
  }

  std::optional<ElementStep> step_of(int element) const {
    if (is_placed(element) || problem().is_line(element)) return std::nullopt;
    ElementStep step;
    step.place = element;
    take_frame(step);
    if (step.positive >= 0 && !problem().is_point(element)) return std::nullopt;
    for (const ElementPair& pair : pairs_)
      for (const std::size_t end : {0, 1}) {
        const int other = pair.of[1 - end];
        if (pair.of[end] != element || !is_placed(other)) continue;
        (problem().is_point(other) ? step.points : step.planes).push_back({other, pair.value});
      }
    const auto cuts = step.zeros.size() + step.points.size() + step.planes.size();
    if (step.points.empty()) {
      const bool meets_planes = problem().is_point(element) && step.planes.size() >= 3;
      return meets_planes ? std::optional(step) : std::nullopt;
    }
    step.first_angle = static_cast<int>(plan_.ranges.size());
    step.angles = std::max(0, enough_cuts + 1 - static_cast<int>(cuts));
    return step;
  }

  void append(ElementStep step) {
    placed_[static_cast<std::size_t>(step.place)] = true;
    if (step.angles > 0) plan_.ranges.push_back({-pi, pi});
    if (step.angles > 1) plan_.ranges.push_back({-pi / 2, pi / 2});
    plan_.steps.push_back(std::move(step));
  }

  const Scene* scene_;
  std::vector<ElementPair> pairs_;
  std::vector<bool> placed_;
  ElementPlan plan_;
};

/// Whether the first leaves less to place, or scans less.
bool is_better(const Placing& a, const Placing& b) {
  if (a.plan().steps.size() != b.plan().steps.size()) return a.plan().steps.size() > b.plan().steps.size();
  return a.plan().ranges.size() < b.plan().ranges.size();
}

/// With positions, from these on; otherwise from the best edge.
Placing best_placing(const Scene& scene) {
  const Placing before(scene);
  Placing best = before;
  if (scene.is_anchored()) best.place_all();
  for (int origin = 0; origin < scene.point_count() && !scene.is_anchored(); ++origin)
    for (int axis = 0; axis < scene.point_count(); ++axis) {
      Placing placing = before;
      placing.place_origin(origin);
      if (!placing.place(axis)) continue;
      placing.place_all();
      if (is_better(placing, best)) best = std::move(placing);
    }
  return best;
}

}  // namespace

std::optional<std::string> why_no_element_plan(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  if (auto reason = why_no_system(scene)) return reason;
  if (!problem.bodies.empty())
    return "no instruction of its plans places the body '" + problem.bodies.front().name + "'";
  if (!problem.lines.empty())
    return "no instruction of its plans places the line '" + problem.lines.front() + "'";
  const int missing = best_placing(scene).missing();
  if (missing < 0) return std::nullopt;
  return std::string("no instruction of its plans places the ") +
         (problem.is_point(missing) ? "point '" : "plane '") + problem.name(missing) +
         "': it has no distance from a point that is placed before it" +
         (problem.is_point(missing) ? ", nor from three planes" : "");
}

ElementPlan derive_element_plan(const Scene& scene) { return best_placing(scene).plan(); }

}  // namespace gcs
