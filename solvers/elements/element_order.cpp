#include "solvers/elements/element_order.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include "solvers/elements/given_elements.hpp"
#include "solvers/elements/stated_signs.hpp"
#include "solvers/model/reframed_scene.hpp"

namespace gcs {
namespace {

// ---- frames

/// The scene with a frame for its general equations; nothing where there are none, or where complex figures
/// are not compared (see assess).
std::optional<Scene> framed(const Scene& scene) {
  ProblemStatement problem = scene.problem();
  if (problem.lines.empty() && !problem.is_general()) return std::nullopt;
  if (!problem.is_general() && !problem.is_anchored() && problem.lines.size() > 1) return std::nullopt;
  if (!stated_signs(problem).empty() || (problem.is_general() && why_no_system(scene))) return std::nullopt;
  if (!problem.is_anchored() && !problem.file_frame && problem.reference_body < 0) {
    if (static_cast<int>(problem.points.size()) < problem.dimension) return std::nullopt;
    problem.reference = reference_of_elements(scene);
  }
  Scene result = Scene::unchecked(std::move(problem));
  return why_no_system(result) ? std::nullopt : std::optional(std::move(result));
}

/// Of points that are no body's: squared lengths between them, −1 where none is given.
class GivenSquares {
 public:
  explicit GivenSquares(const ProblemStatement& problem) {
    for (const DistanceConstraint& c : problem.constraints) {
      const auto is_free = [&](int entity) {
        return problem.is_point(entity) && bodies_with(problem, entity).empty();
      };
      if (is_free(c.between[0]) && is_free(c.between[1])) squares_[key(c)] = c.length() * c.length();
    }
  }

  double between(int a, int b) const {
    const auto found = squares_.find(std::minmax(a, b));
    return found == squares_.end() ? -1 : found->second;
  }
  /// Pairs or, in space, triangles that are not flat.
  std::vector<Reference> frames(int dimension) const {
    std::vector<Reference> found;
    for (const auto& [pair, square] : squares_) {
      if (dimension == 2) found.push_back({pair.first, pair.second});
      for (const auto& [other, further] : squares_)
        if (dimension == 3 && other.first == pair.first && pair.second < other.second &&
            is_triangle(square, further, between(pair.second, other.second)))
          found.push_back({pair.first, pair.second, other.second});
    }
    return found;
  }

 private:
  static std::pair<int, int> key(const DistanceConstraint& c) {
    return std::minmax(c.between[0], c.between[1]);
  }
  /// Whether sixteen times the squared area is positive, beyond rounding.
  static bool is_triangle(double a, double b, double c) {
    constexpr double least = 1e-9;  // of the product of its terms
    return c >= 0 && 4 * a * b - (a + b - c) * (a + b - c) > least * a * b;
  }

  std::map<std::pair<int, int>, double> squares_;
};

/// Whether points make the frame that have given distances from each other. What is no general scene decompose takes
/// apart.
bool has_given_frame(const Scene& scene) {
  if (!scene.problem().is_general()) return false;
  const std::set<int> points = framing_points(scene);
  const GivenSquares squares(scene.problem());
  return std::ranges::all_of(points, [&](int a) {
    return std::ranges::all_of(points, [&](int b) { return a == b || squares.between(a, b) > 0; });
  });
}

/// That of the scene, then others: bodies, and points at given distances from each other.
std::vector<Scene> frames_of(const Scene& scene) {
  const std::optional<Scene> own = framed(scene);
  if (!own) return {};
  std::vector<Scene> frames{*own};
  ProblemStatement problem = own->problem();
  if (!problem.is_general() || problem.has_fixed()) return frames;
  const auto add = [&](const std::optional<Reference>& reference, int body) {
    problem.reference = reference;
    problem.reference_body = body;
    Scene other = Scene::unchecked(problem);
    if (!why_no_system(other)) frames.push_back(std::move(other));
  };
  for (int body = 0; body < static_cast<int>(problem.bodies.size()); ++body)
    if (body != own->problem().reference_body) add(std::nullopt, body);
  for (const Reference& points : GivenSquares(problem).frames(problem.dimension)) add(points, -1);
  return frames;
}

// ---- cores

std::set<int> unknowns_of_frame(const SceneSystem& system) {
  std::set<int> unknowns;
  for (const int point : framing_points(system.elements().scene()))
    unknowns.merge(unknowns_of(system.elements(), point));
  return unknowns;
}

/// Of the unknowns that no step places, those that occur together in equations, directly or by way of others: each
/// time as a core. `given`: unknowns of a frame that they share; the first core has them.
std::vector<PlacingStep> cores(const SceneSystem& system, const std::vector<PlacingStep>& steps,
                               const std::set<int>& given) {
  std::vector<bool> is_left(static_cast<std::size_t>(system.equations().unknowns), true);
  for (const PlacingStep& step : steps)
    for (const int unknown : step.unknowns) is_left[static_cast<std::size_t>(unknown)] = false;
  std::vector<std::set<int>> unknowns, equations;
  std::set<int> of_frame;
  for (std::size_t e = 0; e < system.equations().equations.size(); ++e) {
    std::set<int> together = unknowns_of(system.equations().equations[e]), named{static_cast<int>(e)};
    if (together.empty() ||
        std::ranges::any_of(together, [&](int i) { return !is_left[static_cast<std::size_t>(i)]; }))
      continue;
    for (const int unknown : given) together.erase(unknown);
    if (together.empty()) of_frame.merge(named);
    if (together.empty()) continue;
    for (std::size_t c = unknowns.size(); c-- > 0;) {
      if (!meets(unknowns[c], together)) continue;
      together.merge(unknowns[c]);
      named.merge(equations[c]);
      unknowns.erase(unknowns.begin() + static_cast<std::ptrdiff_t>(c));
      equations.erase(equations.begin() + static_cast<std::ptrdiff_t>(c));
    }
    unknowns.push_back(std::move(together));
    equations.push_back(std::move(named));
  }
  std::vector<PlacingStep> result;
  for (std::size_t c = 0; c < unknowns.size(); ++c) {
    if (c == 0) unknowns[c].insert(given.begin(), given.end());
    if (c == 0) equations[c].merge(of_frame);
    result.emplace_back();
    result.back().unknowns.assign(unknowns[c].begin(), unknowns[c].end());
    result.back().equations.assign(equations[c].begin(), equations[c].end());
  }
  return result;
}

/// Of each entity, whether it is placed by these unknowns, or has its place without any. No entity of a step is: its
/// unknowns are others.
std::vector<bool> placed_by(const SceneSystem& system, const std::set<int>& unknowns) {
  std::vector<bool> result;
  for (int entity = 0; entity < system.elements().problem().entity_count(); ++entity)
    result.push_back(std::ranges::includes(unknowns, unknowns_of(system.elements(), entity)));
  return result;
}

SubProblem alone(const SceneSystem& system, const PlacingStep& core, const std::set<int>& given) {
  std::set<int> unknowns = given;
  unknowns.insert(core.unknowns.begin(), core.unknowns.end());
  return sub_problem(system.elements().problem(), placed_by(system, unknowns));
}

// ---- changes of signs

/// Those that leave what has the masks `before`: masks that differ by these change the same signs.
SignMasks signs_after(const std::vector<SignMask>& before, const SignMasks& masks) {
  std::vector<SignMask> rows = before;
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t j = i + 1; j < rows.size(); ++j)
      if ((rows[j] & rows[i] & -rows[i]) != 0) rows[j] ^= rows[i];
  SignMasks left;
  for (SignMask mask : masks) {
    for (const SignMask row : rows)
      if ((mask & row & -row) != 0) mask ^= row;
    left.push_back(mask);
  }
  return left;
}

SignMasks signs_of(const SceneSystem& system, const auto& unknowns) {
  SignMasks masks;
  for (const int unknown : unknowns)
    masks.push_back(system.equations().mirror[static_cast<std::size_t>(unknown)]);
  return masks;
}

void find_signs(const SceneSystem& system, std::vector<PlacingStep>& steps) {
  std::vector<SignMask> before;
  for (PlacingStep& step : steps) {
    const SignMasks own = signs_of(system, step.unknowns);
    step.signs = signs_after(before, own);
    before.insert(before.end(), own.begin(), own.end());
  }
}

/// Whether it is known how solutions of a core alone are counted in the whole: elements are turned over alike, and the
/// core's mirror images are one solution here too, or two. `given`: unknowns of the frame that were placed before.
bool find_sides(const SceneSystem& system, const std::set<int>& given, PlacingStep& core) {
  const Scene scene = Scene::unchecked(core.alone->problem);
  if (!scene.problem().is_general())
    core.has_two_sides =
        frame_convention(system.elements().problem()) == Convention::up_to_motion || !given.empty();
  if (!scene.problem().is_general()) return true;
  if (why_no_system(scene)) return false;
  const SignMasks masks = SceneSystem(scene).equations().mirror, own = signs_of(system, core.unknowns);
  const int further = masks.rank() - signs_of(system, given).rank() - core.signs.rank();
  core.has_two_sides = further == 1 && convention_of(scene.problem()) == Convention::up_to_reflection;
  return turnings(masks) == turnings(own) && further == (core.has_two_sides ? 1 : 0);
}

// ---- the order

void find_dependences(const SceneSystem& system, std::vector<PlacingStep>& steps) {
  for (std::size_t s = 0; s < steps.size(); ++s) {
    if (steps[s].is_core()) continue;
    std::set<int> here;
    for (const int e : steps[s].equations)
      here.merge(unknowns_of(system.equations().equations[static_cast<std::size_t>(e)]));
    std::set<int> after;
    for (std::size_t before = 0; before < s; ++before)
      if (std::ranges::any_of(steps[before].unknowns, [&](int i) { return here.contains(i); })) {
        after.insert(static_cast<int>(before));
        after.insert(steps[before].after.begin(), steps[before].after.end());
      }
    steps[s].after.assign(after.begin(), after.end());
  }
}

/// Whether a distance or a relation names both.
bool are_stated_together(const ProblemStatement& problem, int a, int b) {
  const auto names = [](const Relation& relation, int entity) {
    return std::ranges::any_of(relation.of, [entity](const Operand& operand) {
      return operand.entity == entity || operand.end == entity;
    });
  };
  return std::ranges::any_of(problem.constraints,
                             [&](const DistanceConstraint& c) {
                               return std::ranges::count(c.between, a) > 0 &&
                                      std::ranges::count(c.between, b) > 0;
                             }) ||
         std::ranges::any_of(problem.relations,
                             [&](const Relation& r) { return names(r, a) && names(r, b); });
}

/// Whether a step's part alone has the step's solutions: with a value, and no plane has lost a side.
bool has_solutions_of(const SceneSystem& system, const PlacingStep& step, const ProblemStatement& part) {
  if (!has_element_equations(part)) return true;
  const Scene scene = Scene::unchecked(part);
  if (why_no_system(scene)) return false;
  const SceneSystem alone(scene);
  return std::ranges::any_of(alone.value_of(), [](int value) { return value >= 0; }) &&
         alone.equations().unknowns == static_cast<int>(step.unknowns.size()) &&
         turnings(alone.equations().mirror) == turnings(signs_of(system, step.unknowns));
}

/// Elements that hang on positions alone, in scenes of their own.
void set_given_steps_apart(const SceneSystem& system, std::vector<PlacingStep>& steps) {
  const ProblemStatement& problem = system.elements().problem();
  if (!problem.is_anchored()) return;
  for (PlacingStep& step : steps) {
    if (step.is_core() || step.bodies > 0 || !step.after.empty()) continue;
    std::vector<bool> is_there = placed_by(system, {});
    for (int entity = 0; entity < problem.entity_count(); ++entity)
      is_there[static_cast<std::size_t>(entity)] = is_there[static_cast<std::size_t>(entity)] &&
                                                   are_stated_together(problem, entity, step.entities[0]);
    is_there[static_cast<std::size_t>(step.entities[0])] = true;
    SubProblem part = sub_problem(problem, is_there);
    if (has_solutions_of(system, step, part.problem)) step.alone = std::move(part);
  }
}

/// Whether a step has each of the unknowns: otherwise those of a frame are left, which would be a core alone.
bool place_all(const std::vector<PlacingStep>& steps, int unknowns) {
  std::set<int> placed;
  for (const PlacingStep& step : steps) placed.insert(step.unknowns.begin(), step.unknowns.end());
  return static_cast<int>(placed.size()) == unknowns;
}

/// Whether nothing is gained: a core is as simple as a simplex or has given positions alone, or there is but one step.
bool is_trivial(const ElementOrder& order, int unknowns) {
  return order.steps.size() < 2 || !place_all(order.steps, unknowns) ||
         std::ranges::any_of(order.steps, [](const PlacingStep& step) {
           if (!step.is_core()) return false;
           const ProblemStatement& core = step.alone->problem;
           return static_cast<int>(given_elements(core).size()) == core.entity_count() ||
                  (!core.is_anchored() && core.bodies.empty() && core.entity_count() < core.dimension + 2);
         });
}

/// Without points that are placed before anything else, where decompose knows them, and without bodies that hang on
/// the frame alone: the core has them.
std::vector<PlacingStep> without_first(const SceneSystem& system, std::vector<PlacingStep> steps) {
  const ProblemStatement& problem = system.elements().problem();
  find_dependences(system, steps);
  std::set<int> of_core;
  for (const PlacingStep& core : cores(system, steps, {}))
    of_core.insert(core.unknowns.begin(), core.unknowns.end());
  std::erase_if(steps, [&](const PlacingStep& step) {
    return step.bodies > 0 && step.after.empty() && std::ranges::none_of(step.equations, [&](int e) {
             return meets(unknowns_of(system.equations().equations[static_cast<std::size_t>(e)]), of_core);
           });
  });
  const auto first = std::ranges::find_if(
      steps, [&](const PlacingStep& step) { return step.bodies > 0 || !problem.is_point(step.entities[0]); });
  std::vector<PlacingStep> later(first, steps.end());
  std::set<int> with_points;
  for (const PlacingStep& core : cores(system, later, {}))
    with_points.insert(core.unknowns.begin(), core.unknowns.end());
  const bool is_known =
      !problem.is_anchored() && !sub_problem(problem, placed_by(system, with_points)).problem.is_general();
  return is_known ? later : steps;
}

/// Nothing where it is not known how a core counts, or nothing is gained.
std::optional<ElementOrder> order_in(const Scene& scene, Taken taken) {
  const SceneSystem system(scene);
  const std::set<int> given = has_given_frame(scene) ? unknowns_of_frame(system) : std::set<int>();
  const std::vector<PlacingStep> steps = without_first(system, placing_steps(system, taken));
  ElementOrder order{scene, cores(system, steps, given)};
  for (PlacingStep& core : order.steps) core.alone = alone(system, core, given);
  std::ranges::copy(steps, std::back_inserter(order.steps));
  find_dependences(system, order.steps);
  find_signs(system, order.steps);
  for (std::size_t i = 0; i < order.steps.size(); ++i)
    if (order.steps[i].is_core() && !find_sides(system, i == 0 ? std::set<int>() : given, order.steps[i]))
      return std::nullopt;
  set_given_steps_apart(system, order.steps);
  return is_trivial(order, system.equations().unknowns) ? std::nullopt : std::optional(std::move(order));
}

/// What is to be made small: cores are solved, at a cost that grows fast with their size.
struct Cost {
  std::size_t one_core = 1;  ///< 0: several
  std::size_t largest_core = 0;

  explicit Cost(const ElementOrder& order) {
    std::size_t count = 0;
    for (const PlacingStep& step : order.steps) {
      if (!step.is_core()) continue;
      ++count;
      largest_core = std::max(largest_core, step.unknowns.size());
    }
    if (count > 1) one_core = 0;
  }
  auto operator<=>(const Cost&) const = default;
};

}  // namespace

std::optional<ElementOrder> element_order(const Scene& scene) {
  if (has_given_shape(scene.problem())) return std::nullopt;
  std::optional<ElementOrder> best;
  const auto compare = [&](std::optional<ElementOrder> order) {
    if (order && (!best || Cost(*order) < Cost(*best))) best = std::move(order);
  };
  const std::vector<Scene> frames = frames_of(scene);
  for (const Scene& frame : frames) compare(order_in(frame, Taken::elements));
  if (best && Cost(*best).one_core == 0) return best;
  for (const Scene& frame : frames)
    if (!frame.problem().bodies.empty()) compare(order_in(frame, Taken::bodies_too));
  return best;
}

}  // namespace gcs
