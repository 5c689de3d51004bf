#include "solvers/reading/instance_hints.hpp"

#include <algorithm>
#include <set>

#include "solvers/model/bend_defect.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/nearest_name.hpp"

namespace gcs {
namespace {

Reference read_line_reference(const JsonCursor& cursor, const ProblemStatement& problem) {
  cursor.allow_members({"line", "height"});
  Reference reference;
  reference.line = line_number(problem, cursor.required("line"));
  reference.height = point_number(problem, cursor.required("height"));
  return reference;
}

Reference read_point_reference(const JsonCursor& cursor, const ProblemStatement& problem) {
  if (problem.dimension == 2 && cursor.has("plane")) {
    cursor.required("plane").fail("a reference in the plane has no plane point", "give origin and axis only");
  }
  cursor.allow_members({"origin", "axis", "plane"});
  Reference reference;
  reference.origin = point_number(problem, cursor.required("origin"));
  reference.axis = point_number(problem, cursor.required("axis"));
  const bool needs_plane = problem.dimension == 3 && problem.points.size() > 2;
  if (needs_plane) reference.plane = point_number(problem, cursor.required("plane"));
  const bool repeated =
      reference.origin == reference.axis ||
      (needs_plane && (reference.plane == reference.origin || reference.plane == reference.axis));
  if (repeated) cursor.fail("a point is named twice", "name different points");
  return reference;
}

/// Reads a construction plan step by step and knows which points are placed.
class PlanReader {
 public:
  explicit PlanReader(const ProblemStatement& problem) : problem_(problem), anchored_(problem.is_anchored()) {
    for (int point = 0; point < static_cast<int>(problem.points.size()); ++point) {
      placed_.push_back(problem.is_fixed(point));
    }
  }

  std::vector<PlanStep> read(const JsonCursor& construction) {
    const std::vector<JsonCursor> steps = construction.elements();
    for (const JsonCursor& step : steps) {
      step.allow_members({"place", "from"});
      if (steps_.empty() && !anchored_) add_omitted_base(step);
      add(read_step(step));
    }
    if (!steps_.empty()) refuse_missing(construction);
    return std::move(steps_);
  }

 private:
  void add(PlanStep step) {
    placed_[step.place] = true;
    steps_.push_back(std::move(step));
  }

  /// How many radii place the next point: the frame takes the coordinates of the first points.
  std::size_t needed_radii() const {
    return std::min(anchored_ ? std::size_t(problem_.dimension) : steps_.size(),
                    std::size_t(problem_.dimension));
  }

  /// The points that a plan may take for granted.
  void add_omitted_base(const JsonCursor& first) {
    const std::vector<JsonCursor> radii = first.required("from").elements();
    if (radii.size() == 1) {
      const int origin = point_number(problem_, radii[0].elements(2, "elements: a point and a radius")[0]);
      if (origin != point_number(problem_, first.required("place"))) add({origin, {}});
    } else if (radii.size() > 1) {
      add_reference(first);
    }
  }

  void add_reference(const JsonCursor& first) {
    if (!problem_.reference || problem_.reference->origin < 0) {
      first.fail("the first step places a point from points that are not placed",
                 "begin with the origin, {\"place\": …, \"from\": []}, or give a 'reference' of points");
    }
    const auto& [origin, axis, plane, line, height] = *problem_.reference;
    std::vector<int> before;
    for (const int point : {origin, axis, plane}) {
      if (point < 0) continue;
      PlanStep step{point, {}};
      for (const int other : before)
        step.from.push_back({other, constraint_between(first, point, other), {}});
      add(std::move(step));
      before.push_back(point);
    }
  }

  int constraint_between(const JsonCursor& step, int a, int b) const {
    for (int i = 0; i < static_cast<int>(problem_.constraints.size()); ++i) {
      if (joins(i, a, b)) return i;
    }
    step.fail("the reference points " + entity_names(problem_, {a, b}) + " have no given distance",
              "place the reference points by steps of the plan, with a driving parameter between these two");
  }

  bool joins(int constraint, int a, int b) const {
    const auto& between = problem_.constraints[constraint].between;
    return (between[0] == a && between[1] == b) || (between[0] == b && between[1] == a);
  }

  PlanStep read_step(const JsonCursor& cursor) {
    const JsonCursor place = cursor.required("place");
    PlanStep step{point_number(problem_, place), {}};
    const std::string& name = problem_.points[step.place];
    if (problem_.is_fixed(step.place)) place.fail("'" + name + "' is fixed", "leave this step out");
    if (placed_[step.place]) place.fail("'" + name + "' is placed already", "place every point once");
    const JsonCursor from = cursor.required("from");
    for (const JsonCursor& radius : from.elements(needed_radii(), "radii at this step")) {
      step.from.push_back(read_radius(radius, step));
    }
    return step;
  }

  PlanStep::Radius read_radius(const JsonCursor& cursor, const PlanStep& step) {
    const auto parts = cursor.elements(2, "elements: a point and a radius");
    PlanStep::Radius radius;
    radius.from = point_number(problem_, parts[0]);
    const std::string& name = problem_.points[radius.from];
    if (!placed_[radius.from])
      parts[0].fail("'" + name + "' is not placed yet", "place it in an earlier step");
    const bool repeated = std::any_of(step.from.begin(), step.from.end(), [&](const PlanStep::Radius& other) {
      return other.from == radius.from;
    });
    if (repeated) parts[0].fail("'" + name + "' is used twice in this step", "name different points");
    const std::string length = parts[1].name();
    if (const auto constraint = constraint_number(problem_, length)) {
      radius.constraint = *constraint;
      refuse_wrong_ends(parts[1], *constraint, step.place, radius.from);
    } else {
      radius.driving = length;
      check_driving(parts[1], length);
    }
    return radius;
  }

  void refuse_wrong_ends(const JsonCursor& cursor, int constraint, int place, int from) const {
    if (joins(constraint, place, from)) return;
    const auto [a, b] = problem_.constraints[constraint].between;
    cursor.fail("'" + problem_.constraints[constraint].id + "' joins " + entity_names(problem_, {a, b}) +
                    " and not " + entity_names(problem_, {from, place}),
                "name a constraint between the two, or a driving parameter");
  }

  void check_driving(const JsonCursor& cursor, const std::string& name) {
    if (name[0] != 'k') {
      cursor.fail("'" + name + "' is neither a constraint nor a driving parameter",
                  "did you mean '" + nearest_name(name, constraint_ids(problem_)) +
                      "'? The names of driving parameters begin with k");
    }
    if (!driving_.insert(name).second) {
      cursor.fail("the driving parameter '" + name + "' is used twice",
                  "give every driving parameter its own name");
    }
  }

  void refuse_missing(const JsonCursor& construction) const {
    std::vector<int> missing;
    for (int point = 0; point < static_cast<int>(placed_.size()); ++point) {
      if (!placed_[point]) missing.push_back(point);
    }
    if (missing.empty()) return;
    construction.fail("the plan does not place " + entity_names(problem_, missing),
                      "add a step for every point");
  }

  const ProblemStatement& problem_;
  bool anchored_;
  std::vector<bool> placed_;
  std::set<std::string> driving_;
  std::vector<PlanStep> steps_;
};

int named_constraint(const JsonCursor& cursor, const std::string& id, const ProblemStatement& problem) {
  const auto constraint = constraint_number(problem, id);
  const bool is_relation = std::any_of(problem.relations.begin(), problem.relations.end(),
                                       [&](const Relation& relation) { return relation.id == id; });
  if (is_relation)
    cursor.fail("'" + id + "' is no distance between points or, in space, of a point from a line",
                "only such lengths can be bent: name one of them");
  if (!constraint) cursor.fail_unknown("there is no constraint '" + id + "'", id, constraint_ids(problem));
  return *constraint;
}

std::vector<BentLength> read_bends(const JsonCursor& bends, const ProblemStatement& problem) {
  std::vector<BentLength> all;
  for (const auto& [id, cursor] : bends.members()) {
    BentLength bent{named_constraint(cursor, id, problem), {}};
    for (const JsonCursor& coefficient : cursor.elements())
      bent.coefficients.push_back(coefficient.number().value);
    if (const auto defect = bend_defect(problem, bent)) cursor.fail(defect->what, defect->remedy);
    all.push_back(std::move(bent));
  }
  return all;
}

}  // namespace

void read_reference(const JsonCursor& reference, ProblemStatement& problem) {
  if (!problem.bodies.empty() && reference.is_object() && reference.has("body")) {
    reference.allow_members({"body"});
    problem.reference_body = body_number(problem, reference.required("body"));
    return;
  }
  const bool with_line = reference.is_object() && (reference.has("line") || reference.has("height"));
  const bool with_points =
      reference.is_object() && (reference.has("origin") || reference.has("axis") || reference.has("plane"));
  if (with_line && with_points) {
    reference.fail("the reference mixes points and a line",
                   "give either origin, axis and plane, or line and height");
  }
  if (with_line && problem.dimension == 2) {
    reference.fail("a reference in the plane has no line", "give origin and axis");
  }
  problem.reference =
      with_line ? read_line_reference(reference, problem) : read_point_reference(reference, problem);
}

InterpolationChoice read_interpolation(const JsonCursor& interpolation, const ProblemStatement& problem) {
  interpolation.allow_members({"bent", "bend", "bends"});
  InterpolationChoice choice;
  if (const auto bends = interpolation.optional("bends")) {
    if (interpolation.has("bent") || interpolation.has("bend"))
      interpolation.fail("'bends' and a single bent constraint exclude each other",
                         "give either 'bends', or 'bent' and 'bend'");
    choice.bends = read_bends(*bends, problem);
    return choice;
  }
  if (const auto bent = interpolation.optional("bent"))
    choice.bent = named_constraint(*bent, bent->name(), problem);
  if (const auto bend = interpolation.optional("bend")) {
    choice.bend = bend->number().value;
    if (!(choice.bend > 0)) {
      bend->fail("the bend is not positive",
                 "give a number > 0, which makes the path bounded so that it closes");
    }
  }
  return choice;
}

std::vector<PlanStep> read_construction(const JsonCursor& construction, const ProblemStatement& problem) {
  if (!construction.elements().empty() && !problem.lines.empty()) {
    construction.fail("a construction plan cannot place lines", "leave the plan out");
  }
  if (!construction.elements().empty() && problem.is_general()) {
    construction.fail("a construction plan uses distances between points alone", "leave the plan out");
  }
  return PlanReader(problem).read(construction);
}

}  // namespace gcs
