#include "solvers/reduction/element_order.hpp"

#include <algorithm>
#include <set>

#include "solvers/elements/stated_signs.hpp"

namespace gcs {
namespace {

/// A step has at most so many paths to its solutions at random numbers (see step_solver.hpp).
constexpr int most_doublings = 12;

std::set<int> unknowns_of(const LinearForm& form) {
  std::set<int> unknowns;
  for (const ScaledUnknown& term : form.terms) unknowns.insert(term.unknown);
  return unknowns;
}

void add(const VectorForm& forms, std::set<int>& unknowns) {
  for (const LinearForm& form : forms) unknowns.merge(unknowns_of(form));
}

/// The unknowns that say where an entity is.
std::set<int> unknowns_of(const SystemBuilder& elements, int entity) {
  const ProblemStatement& problem = elements.problem();
  std::set<int> unknowns;
  if (problem.is_point(entity)) {
    add(elements.point(entity), unknowns);
  } else if (problem.is_line(entity)) {
    add(elements.line(entity).foot, unknowns);
    add(elements.line(entity).direction, unknowns);
  } else {
    add(elements.plane(entity).normal, unknowns);
    unknowns.merge(unknowns_of(elements.plane(entity).offset));
  }
  return unknowns;
}

bool meets(const std::set<int>& a, const std::set<int>& b) {
  return std::ranges::any_of(a, [&](int i) { return b.contains(i); });
}

/// Takes elements away, last ones first, while one hangs on what is left.
class Taking {
 public:
  Taking(const SceneSystem& system, std::vector<bool> is_kept)
      : system_(system), is_kept_(std::move(is_kept)), is_left_(is_kept_.size(), true) {
    for (int entity = 0; entity < static_cast<int>(is_kept_.size()); ++entity)
      of_entity_.push_back(unknowns_of(system.elements(), entity));
    for (const QuadraticEquation& equation : system.equations().equations) {
      of_equation_.emplace_back();
      for (const FormProduct& product : equation.products) {
        of_equation_.back().merge(unknowns_of(product.left));
        of_equation_.back().merge(unknowns_of(product.right));
      }
      is_stated_.push_back(true);
    }
  }

  /// In the order in which they are placed.
  std::vector<PlacingStep> run() {
    while (take_one()) continue;
    std::ranges::reverse(steps_);
    return std::move(steps_);
  }

 private:
  bool take_one() {
    for (int entity = static_cast<int>(is_kept_.size()) - 1; entity >= 0; --entity) {
      const auto i = static_cast<std::size_t>(entity);
      if (is_kept_[i] || !is_left_[i]) continue;
      PlacingStep step = hanging(entity);
      if (step.unknowns.empty() || step.unknowns.size() != step.equations.size() ||
          doublings(step) > most_doublings)
        continue;
      is_left_[i] = false;
      for (const int equation : step.equations) is_stated_[static_cast<std::size_t>(equation)] = false;
      steps_.push_back(std::move(step));
      return true;
    }
    return false;
  }

  /// The element's own unknowns with all that occurs together with them and is of no other element that is left.
  PlacingStep hanging(int entity) const {
    std::set<int> others;
    for (std::size_t other = 0; other < of_entity_.size(); ++other)
      if (is_left_[other] && static_cast<int>(other) != entity)
        others.insert(of_entity_[other].begin(), of_entity_[other].end());
    std::set<int> unknowns, equations;
    const auto take = [&](const std::set<int>& found) {
      std::ranges::copy_if(found, std::inserter(unknowns, unknowns.end()),
                           [&](int unknown) { return !others.contains(unknown); });
    };
    take(of_entity_[static_cast<std::size_t>(entity)]);
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t e = 0; e < of_equation_.size(); ++e) {
        if (!is_stated_[e] || !meets(of_equation_[e], unknowns)) continue;
        if (!equations.insert(static_cast<int>(e)).second) continue;
        take(of_equation_[e]);
        grows = true;
      }
    }
    return {entity, {unknowns.begin(), unknowns.end()}, {equations.begin(), equations.end()}, {}};
  }

  /// Equations of degree two in the step's unknowns.
  int doublings(const PlacingStep& step) const {
    const std::set<int> unknowns(step.unknowns.begin(), step.unknowns.end());
    const auto is_quadratic = [&](int e) {
      const auto& products = system_.equations().equations[static_cast<std::size_t>(e)].products;
      return std::ranges::any_of(products, [&](const FormProduct& product) {
        return meets(unknowns_of(product.left), unknowns) && meets(unknowns_of(product.right), unknowns);
      });
    };
    return static_cast<int>(std::ranges::count_if(step.equations, is_quadratic));
  }

  const SceneSystem& system_;
  std::vector<bool> is_kept_, is_left_;
  std::vector<std::set<int>> of_entity_, of_equation_;
  std::vector<bool> is_stated_;
  std::vector<PlacingStep> steps_;
};

/// The reference of the scene or, where it names a line, that of its points alone.
Reference frame_of(const Scene& scene) {
  if (scene.reference().line < 0) return scene.reference();
  const ProblemStatement& problem = scene.problem();
  std::vector<bool> is_point(static_cast<std::size_t>(problem.entity_count()), false);
  std::fill_n(is_point.begin(), problem.points.size(), true);
  return Scene::unchecked(sub_problem(problem, is_point).problem).reference();
}

/// The scene with a frame for its general equations; nothing where there are none, or where complex figures
/// are not compared (see assess).
std::optional<Scene> framed(const Scene& scene) {
  ProblemStatement problem = scene.problem();
  if (problem.lines.empty() && !problem.is_general()) return std::nullopt;
  if (!problem.is_general() && !problem.is_anchored() && problem.lines.size() > 1) return std::nullopt;
  if (!stated_signs(problem).empty() || (problem.is_general() && why_no_system(scene))) return std::nullopt;
  if (!problem.is_anchored() && problem.reference_body < 0) {
    if (static_cast<int>(problem.points.size()) < problem.dimension) return std::nullopt;
    problem.reference = frame_of(scene);
  }
  Scene result = Scene::unchecked(std::move(problem));
  return why_no_system(result) ? std::nullopt : std::optional(std::move(result));
}

/// What has a place from the start, is moved by a body, or makes the frame.
std::vector<bool> kept(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  std::vector<bool> result;
  for (int entity = 0; entity < problem.entity_count(); ++entity)
    result.push_back(problem.is_fixed(entity) || !bodies_with(problem, entity).empty());
  if (problem.is_anchored() || problem.reference_body >= 0) return result;
  const Reference& frame = scene.reference();
  for (const int point : {frame.origin, frame.axis, frame.plane})
    if (point >= 0) result[static_cast<std::size_t>(point)] = true;
  return result;
}

/// Points that are placed before anything else go back into a core that is not given.
void leave_first_points(const ProblemStatement& problem, std::vector<PlacingStep>& steps) {
  if (problem.is_anchored()) return;
  const auto first =
      std::ranges::find_if(steps, [&](const PlacingStep& step) { return !problem.is_point(step.entity); });
  steps.erase(steps.begin(), first);
}

void find_dependences(const SceneSystem& system, std::vector<PlacingStep>& steps) {
  for (std::size_t s = 0; s < steps.size(); ++s) {
    std::set<int> occurring;
    for (const int e : steps[s].equations)
      for (const FormProduct& product : system.equations().equations[static_cast<std::size_t>(e)].products) {
        occurring.merge(unknowns_of(product.left));
        occurring.merge(unknowns_of(product.right));
      }
    std::set<int> after;
    for (std::size_t before = 0; before < s; ++before)
      if (std::ranges::any_of(steps[before].unknowns, [&](int i) { return occurring.contains(i); })) {
        after.insert(static_cast<int>(before));
        after.insert(steps[before].after.begin(), steps[before].after.end());
      }
    steps[s].after.assign(after.begin(), after.end());
  }
}

int unknowns_of(const std::vector<PlacingStep>& steps) {
  std::size_t sum = 0;
  for (const PlacingStep& step : steps) sum += step.unknowns.size();
  return static_cast<int>(sum);
}

/// Whether what is one solution of the core alone is so in the whole scene: by the changes of signs of both.
bool counts_alike(const ElementOrder& order, const SceneSystem& system) {
  const ProblemStatement& core = order.core.problem;
  if (convention_of(core) != convention_of(order.scene.problem())) return false;
  if (!core.is_general()) return true;
  const Scene alone = Scene::unchecked(core);
  if (why_no_system(alone)) return false;
  std::vector<bool> is_placed_later(static_cast<std::size_t>(system.equations().unknowns));
  for (const PlacingStep& step : order.steps)
    for (const int unknown : step.unknowns) is_placed_later[static_cast<std::size_t>(unknown)] = true;
  SignMasks masks;
  for (std::size_t i = 0; i < is_placed_later.size(); ++i)
    if (!is_placed_later[i]) masks.push_back(system.equations().mirror[i]);
  return masks.rank() == SceneSystem(alone).equations().mirror.rank();
}

/// Whether nothing is gained: the core is as simple as a simplex, or it is given and all else is one step.
bool is_trivial(const ElementOrder& order) {
  const ProblemStatement& core = order.core.problem;
  if (order.core_is_given) return order.steps.size() < 2;
  return core.bodies.empty() && core.entity_count() < core.dimension + 2;
}

}  // namespace

std::optional<ElementOrder> element_order(const Scene& scene) {
  std::optional<Scene> in_frame = framed(scene);
  if (!in_frame) return std::nullopt;
  const ProblemStatement& problem = scene.problem();
  const SceneSystem system(*in_frame);
  ElementOrder order{*in_frame, {}, Taking(system, kept(*in_frame)).run(), {}};
  leave_first_points(problem, order.steps);
  if (order.steps.empty()) return std::nullopt;
  find_dependences(system, order.steps);
  order.is_in_core.assign(static_cast<std::size_t>(problem.entity_count()), true);
  for (const PlacingStep& step : order.steps) order.is_in_core[static_cast<std::size_t>(step.entity)] = false;
  order.core = sub_problem(order.scene.problem(), order.is_in_core);
  order.core_is_given = system.equations().unknowns == unknowns_of(order.steps);
  if (is_trivial(order) || !counts_alike(order, system)) return std::nullopt;
  return order;
}

}  // namespace gcs
