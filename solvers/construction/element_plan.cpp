#include "solvers/construction/element_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "solvers/elements/general_structure.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/model/given_numbers.hpp"
#include "solvers/running/words.hpp"

namespace gcs {
namespace {

using std::numbers::pi;

/// A constraint of two elements, without segments.
struct ElementPair {
  std::array<int, 2> of{};
  GivenFrom given{};  ///< from none of the two yet
};

double length_of(const Scene& scene, const Relation& relation) {
  if (relation.form == Relation::Form::squared)
    return std::ldexp(std::sqrt(relation.given.value), -scene.unit_exponent());
  return rounded_to_double(given_length(scene, relation.given)).real();
}

/// Of unit vectors along lines and normals of planes.
double product_of(const Relation& relation, bool is_beside_plane) {
  const double cosine = rounded_to_double(given_cosine(relation, false)).real();
  return is_beside_plane ? std::sqrt((1 - cosine) * (1 + cosine)) : cosine;
}

GivenFrom given_by(const Scene& scene, const Relation& relation, int constraint) {
  const ProblemStatement& problem = scene.problem();
  const std::string& type = relation.type;
  const auto count = [&](OperandKind kind) {
    return std::ranges::count_if(relation.of,
                                 [&](const Operand& of) { return kind_of(problem, of) == kind; });
  };
  const auto points = count(OperandKind::point), lines = count(OperandKind::line),
             planes = count(OperandKind::plane);
  const bool is_of_line_and_plane = points == 0 && lines == 1;
  const bool is_parallel = type == "parallel", is_perpendicular = type == "perpendicular";
  const bool is_along =
      (is_parallel && (lines == 2 || planes == 2)) || (is_perpendicular && is_of_line_and_plane);
  GivenFrom given;
  given.constraint = constraint;
  if (points == 1 && (type == "distance" || type == "on")) {
    given.met_by = MetBy::distance;
    given.value = type == "on" ? 0 : length_of(scene, relation);
  } else if (is_along) {
    given.met_by = MetBy::one_direction;
  } else if (type == "angle") {
    given.met_by = MetBy::product;
    given.value = product_of(relation, is_of_line_and_plane);
  } else if (is_parallel || is_perpendicular) {
    given.met_by = MetBy::product;
  }
  const bool is_incidence_of_line = type == "on" && lines == 1;
  given.conditions = problem.dimension == 3 && (is_along || is_incidence_of_line) ? 2 : 1;
  return given;
}

std::vector<ElementPair> pairs_of(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  std::vector<ElementPair> pairs;
  int number = 0;
  for (const DistanceConstraint& constraint : problem.constraints) {
    const double length = scene.target_lengths()[static_cast<std::size_t>(number)];
    pairs.push_back({constraint.between, {-1, MetBy::distance, length, 1, number++}});
  }
  for (const Relation& relation : problem.relations) {
    const bool is_pair = relation.of.size() == 2 && !relation.of[0].is_segment() &&
                         !relation.of[1].is_segment() && relation.sign == 0 && relation.type != "collinear";
    if (is_pair)
      pairs.push_back({{relation.of[0].entity, relation.of[1].entity}, given_by(scene, relation, number)});
    ++number;
  }
  return pairs;
}

/// What is given of an element from others.
template <class Taken>
std::vector<GivenFrom> given_of(const ProblemStatement& problem, const std::vector<ElementPair>& pairs,
                                int element, const Taken& is_taken) {
  std::vector<GivenFrom> given;
  for (const ElementPair& pair : pairs)
    for (const std::size_t end : {0, 1}) {
      const int other = pair.of[1 - end];
      if (pair.of[end] != element || !is_taken(other)) continue;
      given.push_back(pair.given);
      given.back().other = other;
    }
  std::ranges::stable_sort(given, {}, [&](const GivenFrom& from) { return rank_of(problem, from.other); });
  return given;
}

/// Places elements one after the other.
class Placing {
 public:
  Placing(const Scene& scene, Instructions instructions)
      : scene_(&scene),
        instructions_(instructions),
        pairs_(pairs_of(scene)),
        placed_(static_cast<std::size_t>(problem().entity_count())) {
    const ProblemStatement with_given = with_given_body(problem());
    if (!needs_frame())
      for (const BodyElement& element :
           with_given.bodies[static_cast<std::size_t>(with_given.reference_body)].elements)
        placed_[static_cast<std::size_t>(element.entity)] = true;
  }

  bool needs_frame() const { return !scene_->is_anchored() && !has_resting_body(); }
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
  /// Of the elements that are not placed, the first that is met by the most; −1: none.
  int missing() const {
    int best = -1;
    std::size_t most = 0;
    for (int element = 0; element < problem().entity_count(); ++element) {
      if (is_placed(element)) continue;
      const std::size_t met = given_before(element).size();
      if (best < 0 || met > most) best = element;
      most = std::max(most, met);
    }
    return best;
  }
  /// "distance from 'p1', on 'l2'": from elements that are placed.
  std::string meetings(int element) const {
    std::string text;
    for (const GivenFrom& from : given_before(element))
      text += (text.empty() ? "" : ", ") + name_of(from) + " '" + problem().name(from.other) + "'";
    return text;
  }

 private:
  const ProblemStatement& problem() const { return scene_->problem(); }
  bool is_placed(int element) const { return placed_[static_cast<std::size_t>(element)]; }
  bool has_resting_body() const { return !scene_->is_anchored() && problem().reference_body >= 0; }
  std::vector<GivenFrom> given_before(int element) const {
    return given_of(problem(), pairs_, element, [this](int other) { return is_placed(other); });
  }
  std::string name_of(const GivenFrom& from) const {
    const int relation = from.constraint - scene_->constraint_count();
    return relation < 0 ? "distance" : problem().relations[static_cast<std::size_t>(relation)].type;
  }

  /// Zeros and the sign by which the frame places the point that comes next.
  void take_frame(ElementStep& step) const {
    const auto before = static_cast<int>(plan_.steps.size());
    if (needs_frame() && before < scene_->dimension()) {
      step.positive = before - 1;
      for (int axis = before; axis < scene_->dimension(); ++axis) step.zeros.push_back(axis);
    }
    const bool has_third_axis = scene_->dimension() == 3 || problem().is_line(step.place);
    if (!has_third_axis) step.zeros.push_back(2);
  }

  std::optional<ElementStep> step_of(int element) const {
    if (is_placed(element) || !bodies_with(problem(), element).empty()) return std::nullopt;
    ElementStep step;
    step.place = element;
    take_frame(step);
    if (step.positive >= 0 && !problem().is_point(element)) return std::nullopt;
    step.given = given_before(element);
    if (instructions_ == Instructions::all_places)
      step.given = used_in_closed_form(problem(), element, static_cast<int>(step.zeros.size()), step.given);
    if (step.given.empty()) return std::nullopt;
    int open = coordinates_of(problem(), element) - static_cast<int>(step.zeros.size());
    for (const GivenFrom& from : step.given) open -= from.conditions;
    step.first_angle = static_cast<int>(plan_.ranges.size());
    step.angles = std::max(0, open);
    return step;
  }

  void append(ElementStep step) {
    placed_[static_cast<std::size_t>(step.place)] = true;
    for (int angle = 0; angle < step.angles; ++angle) {
      const double end = angle == 1 ? pi / 2 : pi;
      plan_.ranges.push_back({-end, end});
    }
    plan_.steps.push_back(std::move(step));
  }

  const Scene* scene_;
  Instructions instructions_;
  std::vector<ElementPair> pairs_;
  std::vector<bool> placed_;
  ElementPlan plan_;
};

/// Whether the first leaves less to place, or scans less.
bool is_better(const Placing& a, const Placing& b) {
  if (a.plan().steps.size() != b.plan().steps.size()) return a.plan().steps.size() > b.plan().steps.size();
  return a.plan().ranges.size() < b.plan().ranges.size();
}

/// With positions or a body at rest, from these on; otherwise from the best edge.
Placing best_placing(const Scene& scene, Instructions instructions) {
  const Placing before(scene, instructions);
  Placing best = before;
  if (!before.needs_frame()) best.place_all();
  for (int origin = 0; origin < scene.point_count() && before.needs_frame(); ++origin)
    for (int axis = 0; axis < scene.point_count(); ++axis) {
      Placing placing = before;
      placing.place_origin(origin);
      if (!placing.place(axis)) continue;
      placing.place_all();
      if (is_better(placing, best)) best = std::move(placing);
    }
  return best;
}

/// What a reader calls the step that no instruction does, and what it is met by.
std::string without_instruction(const ProblemStatement& problem, const Placing& placing, int element) {
  const std::vector<int> bodies = bodies_with(problem, element);
  std::string text = "no instruction places the ", meetings;
  if (bodies.empty()) {
    text += std::string(problem.is_point(element)   ? "point"
                        : problem.is_plane(element) ? "plane"
                                                    : "line") +
            " '" + problem.name(element) + "'";
    meetings = placing.meetings(element);
  } else {
    const RigidBody& body = problem.bodies[static_cast<std::size_t>(bodies.front())];
    text += "body '" + body.name + "'";
    for (const BodyElement& one : body.elements)
      if (const std::string more = placing.meetings(one.entity); !more.empty())
        meetings += (meetings.empty() ? "" : ", ") + more;
  }
  if (meetings.empty()) return text + ", which is met by nothing that is placed before it";
  return text + ", which is met by: " + meetings;
}

}  // namespace

int coordinates_of(const ProblemStatement& problem, int element) {
  if (problem.is_line(element)) return problem.dimension == 2 ? 2 : 4;
  return 3;
}

Reference ElementPlan::frame() const {
  Reference reference;
  if (steps.empty() || !steps[0].is_origin) return reference;
  reference.origin = steps[0].place;
  if (steps.size() > 1) reference.axis = steps[1].place;
  if (steps.size() > 2 && steps[2].positive == 1) reference.plane = steps[2].place;
  return reference;
}

std::optional<std::string> why_no_element_plan(const Scene& scene, Instructions instructions) {
  if (auto reason = why_no_system(scene)) return reason;
  if (has_given_shape(scene.problem()))
    return "a plan begins with given positions that leave no motion, or with one that does";
  const Placing placing = best_placing(scene, instructions);
  const int missing = placing.missing();
  if (missing < 0) return std::nullopt;
  return without_instruction(scene.problem(), placing, missing);
}

ElementPlan derive_element_plan(const Scene& scene, Instructions instructions) {
  return best_placing(scene, instructions).plan();
}

std::vector<std::string> describe_plan(const ProblemStatement& problem, const ElementPlan& plan) {
  std::vector<std::string> texts;
  for (const ElementStep& step : plan.steps) {
    std::string text = problem.name(step.place) + (step.is_origin ? " at the origin" : " from ");
    for (const GivenFrom& from : step.given)
      text += fmt::format("{}{} ({})", &from == step.given.data() ? "" : ", ", problem.name(from.other),
                          id_of_value(problem, from.constraint));
    if (step.angles > 0) text += "; " + counted(step.angles, "driving parameter");
    texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace gcs
