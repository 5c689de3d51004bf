#include "solvers/scanning/element_unknowns.hpp"

#include <algorithm>
#include <set>

namespace gcs {
namespace {

using Part = UnknownOfElement::Part;

struct ElementForms {
  Part part;
  VectorForm forms;
};

std::vector<ElementForms> forms_of(const SystemBuilder& elements, int entity) {
  const ProblemStatement& problem = elements.problem();
  if (problem.is_point(entity)) return {{Part::point, elements.point(entity)}};
  if (problem.is_line(entity)) {
    const LineForms& line = elements.line(entity);
    return {{Part::foot, line.foot}, {Part::direction, line.direction}};
  }
  const PlaneForms& plane = elements.plane(entity);
  return {{Part::normal, plane.normal}, {Part::offset, {plane.offset}}};
}

bool is_given(const std::vector<ElementForms>& parts) {
  return std::ranges::all_of(parts, [](const ElementForms& part) {
    return std::ranges::all_of(part.forms, [](const LinearForm& form) { return form.terms.empty(); });
  });
}

/// Whether the form is an unknown or its opposite.
bool is_unknown(const LinearForm& form) {
  return form.terms.size() == 1 && form.constant.is_zero() && form.terms[0].coefficient.decimal.empty() &&
         form.terms[0].coefficient.value == 1.0 && form.terms[0].coefficient.exponent == 0;
}

class Search {
 public:
  Search(const SceneSystem& system, const IntervalEquations& equations)
      : system_(system),
        equations_(equations),
        is_known_(static_cast<std::size_t>(equations.unknowns)),
        is_taken_(equations.equations.size()) {
    for (const IntervalEquation& equation : equations.equations) unknowns_.push_back(unknowns_of(equation));
    find_segments();
  }

  ElementUnknowns run(const ElementPlan& plan) {
    const SystemBuilder& elements = system_.elements();
    ElementUnknowns found;
    for (int entity = 0; entity < elements.problem().entity_count(); ++entity)
      if (is_given(forms_of(elements, entity)) && !is_placed_by(plan, entity)) {
        found.resting.push_back(entity);
        placed_.insert(entity);
      }
    follow({}, found.at_rest);
    for (const ElementStep& step : plan.steps) {
      KnownAtStep known;
      const bool is_on_its_own = take(step.place, known);
      placed_.insert(step.place);
      follow(is_on_its_own ? used_to_place(step) : std::vector<int>(), known);
      found.steps.push_back(std::move(known));
    }
    for (std::size_t e = 0; e < unknowns_.size(); ++e)
      if (!std::ranges::all_of(unknowns_[e], [&](int unknown) { return is_known(unknown); }))
        found.missing.push_back(static_cast<int>(e));
    return found;
  }

 private:
  static bool is_placed_by(const ElementPlan& plan, int entity) {
    return std::ranges::any_of(plan.steps, [&](const ElementStep& step) { return step.place == entity; });
  }

  /// Instructions use the first that are given: as many as leave no coordinate open.
  std::vector<int> used_to_place(const ElementStep& step) const {
    const ProblemStatement& problem = system_.elements().problem();
    int open = coordinates_of(problem, step.place) - static_cast<int>(step.zeros.size());
    std::vector<int> used;
    for (const GivenFrom& given : step.given) {
      if (open <= 0) break;
      used.push_back(given.constraint);
      open -= given.conditions;
    }
    return used;
  }

  std::vector<int> unknowns_of(const IntervalEquation& equation) const {
    std::set<int> found;
    for (const IntervalProduct& product : equation.products)
      for (const int form : {product.left, product.right})
        for (const IntervalForm::Term& term : equations_.forms[static_cast<std::size_t>(form)].terms)
          found.insert(term.unknown);
    return {found.begin(), found.end()};
  }

  /// Those that have unknowns.
  void find_segments() {
    SystemBuilder elements = system_.elements();
    for (const Relation& relation : elements.problem().relations)
      for (const Operand& operand : relation.of) {
        if (!operand.is_segment()) continue;
        const auto [from, to] = std::minmax(operand.entity, operand.end);
        const SegmentForms forms = elements.segment({from, to});
        if (!is_unknown(forms.length) || forms.length.terms[0].unknown >= equations_.unknowns) continue;
        UnknownsOfSegment segment{from, to, forms.length.terms[0].unknown, false, {}};
        for (const LinearForm& form : forms.direction)
          if (is_unknown(form)) segment.direction.push_back(form.terms[0].unknown);
        segments_.push_back(std::move(segment));
      }
  }

  void take_segments(KnownAtStep& known) {
    for (UnknownsOfSegment segment : segments_) {
      if (is_known(segment.direction.front()) || !placed_.contains(segment.from) ||
          !placed_.contains(segment.to))
        continue;
      segment.is_length_known = is_known(segment.length);
      learn(segment.length);
      for (const int unknown : segment.direction) learn(unknown);
      known.of_segments.push_back(std::move(segment));
    }
  }

  bool is_known(int unknown) const { return is_known_[static_cast<std::size_t>(unknown)]; }
  void learn(int unknown) { is_known_[static_cast<std::size_t>(unknown)] = true; }

  /// False where the element has unknowns of one before: equations say of these what no constraint does.
  bool take(int entity, KnownAtStep& known) {
    bool is_on_its_own = true;
    for (const auto& [part, forms] : forms_of(system_.elements(), entity))
      for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!is_unknown(forms[axis])) continue;
        const ScaledUnknown& term = forms[axis].terms[0];
        if (is_known(term.unknown)) {
          is_on_its_own = false;
          continue;
        }
        learn(term.unknown);
        known.of_elements.push_back(
            {term.unknown, entity, part, static_cast<int>(axis), term.coefficient.is_negative});
      }
    return is_on_its_own;
  }

  /// What follows by equations, and which of these can be checked now. `used`: constraints that placed the element.
  void follow(const std::vector<int>& used, KnownAtStep& known) {
    take_segments(known);
    for (bool is_more = true; is_more;) {
      is_more = false;
      for (int unknown = 0; unknown < equations_.unknowns; ++unknown) {
        if (is_known(unknown)) continue;
        const std::vector<int> by = equations_for(unknown);
        if (by.empty()) continue;
        learn(unknown);
        if (by.size() == 1) is_taken_[static_cast<std::size_t>(by[0])] = true;
        known.of_equations.push_back({unknown, by});
        is_more = true;
      }
    }
    for (std::size_t e = 0; e < unknowns_.size(); ++e) {
      const int owner = system_.owner_of()[e];
      if (is_taken_[e] || !std::ranges::all_of(unknowns_[e], [&](int unknown) { return is_known(unknown); }))
        continue;
      is_taken_[e] = true;
      if (owner >= 0 && std::ranges::find(used, owner) == used.end())
        known.checks.push_back(static_cast<int>(e));
    }
  }

  /// Those in which it is linear and everything else is known.
  std::vector<int> equations_for(int unknown) const {
    std::vector<int> found;
    for (std::size_t e = 0; e < unknowns_.size(); ++e) {
      const bool fits =
          std::ranges::all_of(unknowns_[e], [&](int other) { return other == unknown || is_known(other); });
      if (fits && std::ranges::find(unknowns_[e], unknown) != unknowns_[e].end() &&
          is_linear(equations_.equations[e], unknown))
        found.push_back(static_cast<int>(e));
    }
    return found;
  }

  bool is_linear(const IntervalEquation& equation, int unknown) const {
    const auto has = [&](int form) {
      return std::ranges::any_of(equations_.forms[static_cast<std::size_t>(form)].terms,
                                 [&](const IntervalForm::Term& term) { return term.unknown == unknown; });
    };
    return std::ranges::none_of(equation.products, [&](const IntervalProduct& product) {
      return has(product.left) && has(product.right);
    });
  }

  const SceneSystem& system_;
  const IntervalEquations& equations_;
  std::vector<std::vector<int>> unknowns_;  // of each equation
  std::vector<UnknownsOfSegment> segments_;
  std::set<int> placed_;
  std::vector<bool> is_known_;
  std::vector<bool> is_taken_;  // of the equations
};

}  // namespace

ElementUnknowns element_unknowns(const SceneSystem& system, const IntervalEquations& equations,
                                 const ElementPlan& plan) {
  return Search(system, equations).run(plan);
}

}  // namespace gcs
