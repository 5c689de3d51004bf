#include "solvers/scanning/element_subdivision.hpp"

#include <limits>

#include "solvers/certificates/box_search.hpp"
#include "solvers/elements/general_structure.hpp"
#include "solvers/model/given_numbers.hpp"
#include "solvers/scanning/cell_scan.hpp"
#include "solvers/scanning/element_pieces.hpp"
#include "solvers/scanning/element_unknowns.hpp"
#include "solvers/scanning/form_equations.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

constexpr int most_symbols = 3;

Scene in_frame_of(const Scene& scene, const ElementPlan& plan) {
  ProblemStatement problem = scene.problem();
  if (const Reference frame = plan.frame(); frame.origin >= 0) problem.reference = frame;
  return Scene::unchecked(std::move(problem));
}

/// A point beside a line is on a circle at an angle that is no angle of the plan.
int symbols_of(const Scene& scene, const ElementPlan& plan) {
  const ProblemStatement& problem = scene.problem();
  bool has_tube = false;
  for (const ElementStep& step : plan.steps)
    for (const GivenFrom& given : step.given)
      has_tube = has_tube ||
                 (problem.dimension == 3 && problem.is_point(step.place) && problem.is_line(given.other));
  return static_cast<int>(plan.ranges.size()) + (has_tube ? 1 : 0);
}

template <int N>
GivenForm<N> of_value(const AffineForm<N>& value) {
  return {value, square(value)};
}
template <int N>
GivenForm<N> of_square(const AffineForm<N>& square) {
  return {sqrt(square), square};
}

template <int N>
AffineForm<N> form_of(const ExactNumber& number) {
  return enclosing_form<N>(nearest_double_double(number));
}

/// The file's number in the scene's unit.
template <int N>
GivenForm<N> given_form(const Scene& scene, const GivenFrom& given) {
  const ProblemStatement& problem = scene.problem();
  if (given.constraint < scene.constraint_count()) {
    const DistanceConstraint& distance = problem.constraints[static_cast<std::size_t>(given.constraint)];
    if (distance.is_squared) return of_square(form_of<N>(given_square(scene, given.constraint)));
    return of_value(form_of<N>(given_length(scene, distance.given)));
  }
  const Relation& relation =
      problem.relations[static_cast<std::size_t>(given.constraint - scene.constraint_count())];
  if (relation.type == "angle") {
    const bool is_beside_plane =
        problem.is_plane(relation.of[0].entity) != problem.is_plane(relation.of[1].entity);
    if (is_beside_plane) return of_square(AffineForm<N>(1) - form_of<N>(given_cosine(relation, true)));
    return of_value(form_of<N>(given_cosine(relation, false)));
  }
  if (relation.type != "distance") return {};
  ExactNumber number = given_length(scene, relation.given);
  if (relation.form != Relation::Form::squared) return of_value(form_of<N>(number));
  number.exponent *= 2;
  return of_square(form_of<N>(number));
}

template <int N>
FormVector<N> given_vector(const VectorForm& forms) {
  return {form_of<N>(forms[0].constant), form_of<N>(forms[1].constant), form_of<N>(forms[2].constant)};
}

/// A plan of points, lines and planes: see CellScan.
template <int N>
class ElementStage {
 public:
  using Form = AffineForm<N>;
  using Position = FormVector<N>;
  using Positions = std::vector<Position>;  ///< of the elements, and a component for each unknown

  /// `scene`: in the plan's frame. Keeps references.
  ElementStage(const Scene& scene, const ElementPlan& plan)
      : problem_(scene.problem()),
        plan_(plan),
        size_(scene.size()),
        slots_(problem_),
        system_(scene),
        equations_(system_.equations()),
        forms_(equations_),
        known_(element_unknowns(system_, equations_, plan)),
        test_(equations_, size_),
        start_(slots_.count() + static_cast<std::size_t>(equations_.unknowns)) {
    for (const ElementStep& step : plan.steps) {
      given_.emplace_back();
      for (const GivenFrom& given : step.given) given_.back().push_back(given_form<N>(scene, given));
    }
    for (const int entity : known_.resting) rest(entity);
    learn(known_.at_rest, start_);
  }
  ElementStage(const ElementStage&) = delete;  // the test refers to the equations

  std::size_t steps() const { return plan_.steps.size(); }
  const std::vector<std::array<double, 2>>& ranges() const { return plan_.ranges; }
  double size() const { return size_; }
  Positions start() const { return start_; }

  Pieces<N> pieces(std::size_t k, const Positions& positions, const Cell<N>& cell,
                   const std::optional<Choice>& within) const {
    return at_step(k, positions, cell, within).pieces();
  }

  bool put(std::size_t k, const Piece<N>& piece, Positions& positions, Narrowing<N>& narrowing) const {
    const int entity = plan_.steps[k].place;
    const auto vectors = at_step(k, positions, {}, std::nullopt).element_at(piece.position);
    positions[slots_.first(entity)] = vectors[0];
    if (!problem_.is_point(entity)) positions[slots_.second(entity)] = vectors[1];
    const KnownAtStep& known = known_.steps[k];
    learn(known, positions);
    const auto x = [&](int unknown) -> const Form& { return of_unknown(positions, unknown); };
    return std::ranges::all_of(known.checks,
                               [&](int equation) { return narrowing.by_zero(forms_.excess(equation, x)); });
  }

  Box box(const Positions& positions) const {
    Box box{Eigen::VectorXd(equations_.unknowns), Eigen::VectorXd(equations_.unknowns)};
    for (int i = 0; i < equations_.unknowns; ++i) {
      const Form& x = of_unknown(positions, i);
      box.mid[i] = x.is_finite() ? x.mid : 0;
      box.radius[i] = x.is_finite() ? radius_about_middle(x) : std::numeric_limits<double>::infinity();
    }
    return box;
  }

  const QuadraticSystem& equations() const { return system_.equations(); }
  BoxContent content(const Box& box) const {
    const auto image = test_.image(box);
    if (!image) return BoxContent::unknown;
    if (image->is_inside(box.radius)) return BoxContent::one_solution;
    return image->misses(box.radius) ? BoxContent::no_solution : BoxContent::unknown;
  }
  bool refine(Eigen::VectorXd& x, std::int64_t& iterations) const { return test_.refine(x, iterations); }
  std::optional<std::vector<Box>> solutions_in(const Box& box) const {
    constexpr int most_parts = 2000;  // tens of milliseconds
    return gcs::solutions_in(test_, box, most_parts);
  }

  std::optional<Box> image_near(const Box& box, const Box& known) const {
    const SignMasks& mirror = system_.equations().mirror;
    const auto fits = [&](std::size_t unknown, double sign) {
      const auto i = static_cast<Eigen::Index>(unknown);
      const double apart = std::abs(known.mid[i] - sign * box.mid[i]) * (1 + 4 * Form::epsilon);
      return !(apart > known.radius[i] + box.radius[i]);
    };
    if (!some_signs_fit(mirror, fits)) return std::nullopt;
    return Box{turned_towards(mirror, box.mid, known.mid), box.radius};
  }

  Figure figure(const Eigen::VectorXd& x) const {
    return system_.figure(ComplexValues(x.begin(), x.end()), true);
  }

  ScanSolution solution(const Box& box) const {
    ScanSolution solution{figure(box.mid)};
    const ComplexValues x = system_.coordinates(solution.figure);
    const Eigen::VectorXd drawn = real_parts(x),
                          image = turned_towards(system_.equations().mirror, box.mid, drawn);
    std::vector<double> offsets;
    for (Eigen::Index i = 0; i < image.size(); ++i)
      offsets.push_back((std::abs(drawn[i] - image[i]) + box.radius[i]) * (1 + 4 * Form::epsilon));
    solution.error = system_.distance(solution.figure, x, offsets);
    return solution;
  }

 private:
  ElementPieces<N> at_step(std::size_t k, const Positions& positions, const Cell<N>& cell,
                           const std::optional<Choice>& within) const {
    return {
        problem_, plan_.steps[k], given_[k], positions, cell, within, static_cast<int>(plan_.ranges.size())};
  }

  const Form& of_unknown(const Positions& positions, int unknown) const {
    return positions[slots_.count() + static_cast<std::size_t>(unknown)][0];
  }
  Form& of_unknown(Positions& positions, int unknown) const {
    return positions[slots_.count() + static_cast<std::size_t>(unknown)][0];
  }

  void rest(int entity) {
    const SystemBuilder& elements = system_.elements();
    Position& first = start_[slots_.first(entity)];
    if (problem_.is_point(entity)) {
      first = given_vector<N>(elements.point(entity));
    } else if (problem_.is_line(entity)) {
      first = given_vector<N>(elements.line(entity).foot);
      start_[slots_.second(entity)] = given_vector<N>(elements.line(entity).direction);
    } else {
      first = given_vector<N>(elements.plane(entity).normal);
      start_[slots_.second(entity)][0] = form_of<N>(elements.plane(entity).offset.constant);
    }
  }

  void learn(const KnownAtStep& known, Positions& positions) const {
    for (const UnknownOfElement& one : known.of_elements) {
      const Form x = component(one, positions);
      of_unknown(positions, one.unknown) = one.is_opposite ? -x : x;
    }
    for (const UnknownsOfSegment& one : known.of_segments) learn_segment(one, positions);
    for (const UnknownOfEquations& one : known.of_equations)
      of_unknown(positions, one.unknown) = solved(one, positions);
  }

  Form component(const UnknownOfElement& one, const Positions& positions) const {
    using enum UnknownOfElement::Part;
    const Position& first = positions[slots_.first(one.entity)];
    if (one.part == point || one.part == normal) return first[one.axis];
    const Position& second = positions[slots_.second(one.entity)];
    if (one.part == direction) return second[one.axis];
    if (one.part == offset) return second[0];
    return (first - dot(first, second) * second)[one.axis];
  }

  /// Of the equations rate·x + rest = 0, of which all hold, Σ rate² x + Σ rate·rest = 0.
  Form solved(const UnknownOfEquations& one, const Positions& positions) const {
    const auto x = [&](int unknown) -> const Form& { return of_unknown(positions, unknown); };
    Form rates, rests;
    for (const int equation : one.equations) {
      const auto line = forms_.line(equation, one.unknown, x);
      rates = rates + square(line.rate);
      rests = rests + line.rate * line.rest;
    }
    return has_reciprocal(rates) ? -reciprocal(rates) * rests : anything();
  }

  void learn_segment(const UnknownsOfSegment& one, Positions& positions) const {
    const Position way = positions[slots_.first(one.to)] - positions[slots_.first(one.from)];
    Form& length = of_unknown(positions, one.length);
    if (!one.is_length_known) length = sqrt(square(way));
    const bool is_bounded = has_reciprocal(length);
    for (std::size_t axis = 0; axis < one.direction.size(); ++axis)
      of_unknown(positions, one.direction[axis]) = is_bounded ? reciprocal(length) * way[axis] : anything();
  }

  static Form anything() {
    Form form;
    form.rest = std::numeric_limits<double>::infinity();
    return form;
  }

  const ProblemStatement& problem_;
  const ElementPlan& plan_;
  double size_;
  ElementSlots slots_;
  SceneSystem system_;
  IntervalEquations equations_;
  FormsOfEquations<N> forms_;
  ElementUnknowns known_;
  KrawczykTest test_;
  Positions start_;
  std::vector<std::vector<GivenForm<N>>> given_;  // by step
};

template <int N>
ScanOutcome subdivided(const SolveRequest& request, const Scene& scene, const ElementPlan& plan,
                       std::int64_t max_cells) {
  const ElementStage<N> stage(scene, plan);
  return CellScan<N, ElementStage<N>>(request, stage, max_cells).run();
}

}  // namespace

std::optional<std::string> why_no_element_subdivision(const Scene& scene, const ElementPlan& plan) {
  if (const int symbols = symbols_of(scene, plan); symbols > most_symbols)
    return "its subdivision has at most " + std::to_string(most_symbols) +
           " angles, that of a point on a cylinder included, and the plan has " + std::to_string(symbols);
  const Scene framed = in_frame_of(scene, plan);
  const SceneSystem system(framed);
  const ElementUnknowns known = element_unknowns(system, IntervalEquations(system.equations()), plan);
  if (known.missing.empty()) return std::nullopt;
  const int owner = system.owner_of()[static_cast<std::size_t>(known.missing.front())];
  const std::string of_owner =
      owner < 0 ? "" : " of constraint '" + id_of_value(scene.problem(), owner) + "'";
  return "its subdivision has no enclosures of the unknowns" + of_owner +
         "; method=published scans all that its plans place";
}

ScanOutcome subdivide_element_plan(const SolveRequest& request, const ElementPlan& plan,
                                   std::int64_t max_cells) {
  const Scene scene = in_frame_of(request.scene, plan);
  const int symbols = symbols_of(scene, plan);
  if (symbols <= 1) return subdivided<1>(request, scene, plan, max_cells);
  if (symbols == 2) return subdivided<2>(request, scene, plan, max_cells);
  return subdivided<3>(request, scene, plan, max_cells);
}

}  // namespace gcs
