#include "solvers/elements/placing_steps.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "solvers/running/words.hpp"

namespace gcs {
namespace {

/// Of a step's equations at most so many are quadratic: then it has at most 2^12 solutions.
constexpr int most_quadratic = 12;

std::set<int> unknowns_of(const LinearForm& form) {
  std::set<int> unknowns;
  for (const ScaledUnknown& term : form.terms) unknowns.insert(term.unknown);
  return unknowns;
}

void add(const VectorForm& forms, std::set<int>& unknowns) {
  for (const LinearForm& form : forms) unknowns.merge(unknowns_of(form));
}

/// What is placed as one: a body, or an element of none.
struct Piece {
  std::string name;
  std::vector<int> entities;
  bool is_left = true;
};

/// The bodies first, so many. `kept`: pieces that are not taken.
struct Pieces {
  std::vector<Piece> all;
  std::set<std::size_t> kept;
  std::size_t bodies = 0;

  Pieces(const Scene& scene, Taken taken) {
    const ProblemStatement& problem = scene.problem();
    for (int body = 0; body < static_cast<int>(problem.bodies.size()); ++body) {
      if (taken == Taken::elements || body == problem.reference_body) kept.insert(all.size());
      const RigidBody& of = problem.bodies[static_cast<std::size_t>(body)];
      all.push_back({of.name, {}});
      for (const BodyElement& element : of.elements) all.back().entities.push_back(element.entity);
    }
    bodies = all.size();
    const std::set<int> in_frame = framing_points(scene);
    for (int entity = 0; entity < problem.entity_count(); ++entity) {
      if (!bodies_with(problem, entity).empty()) continue;
      if (problem.is_fixed(entity) || in_frame.contains(entity)) kept.insert(all.size());
      all.push_back({problem.name(entity), {entity}});
    }
  }
};

class Taking {
 public:
  Taking(const SceneSystem& system, Taken taken)
      : system_(system), pieces_(system.elements().scene(), taken) {
    for (const Piece& piece : pieces_.all) {
      of_piece_.emplace_back();
      for (const int entity : piece.entities)
        of_piece_.back().merge(gcs::unknowns_of(system.elements(), entity));
    }
    for (const QuadraticEquation& equation : system.equations().equations) {
      of_equation_.push_back(gcs::unknowns_of(equation));
      is_stated_.push_back(true);
    }
  }

  std::vector<PlacingStep> run() {
    while (take_one()) continue;
    std::ranges::reverse(steps_);
    return std::move(steps_);
  }

 private:
  using Group = std::vector<std::size_t>;

  /// One piece, or otherwise two bodies that can only be placed together.
  bool take_one() {
    for (std::size_t piece = pieces_.all.size(); piece-- > 0;)
      if (take({piece})) return true;
    for (std::size_t a = 0; a < pieces_.bodies; ++a)
      for (std::size_t b = a + 1; b < pieces_.bodies; ++b)
        if (take({a, b})) return true;
    return false;
  }

  bool can_be_taken(std::size_t piece) const {
    return !pieces_.kept.contains(piece) && pieces_.all[piece].is_left;
  }

  bool take(const Group& group) {
    if (!std::ranges::all_of(group, [this](std::size_t piece) { return can_be_taken(piece); })) return false;
    PlacingStep step = hanging(group);
    step.quadratic = quadratic(step);
    if (step.unknowns.empty() || step.unknowns.size() != step.equations.size() ||
        step.quadratic > most_quadratic)
      return false;
    for (const std::size_t piece : group) pieces_.all[piece].is_left = false;
    for (const int equation : step.equations) is_stated_[static_cast<std::size_t>(equation)] = false;
    steps_.push_back(std::move(step));
    return true;
  }

  /// Their own unknowns with all that occurs together with them and is of no other piece that is left.
  PlacingStep hanging(const Group& group) const {
    std::set<int> others, unknowns, equations;
    for (std::size_t other = 0; other < of_piece_.size(); ++other)
      if (pieces_.all[other].is_left && std::ranges::find(group, other) == group.end())
        others.insert(of_piece_[other].begin(), of_piece_[other].end());
    const auto take = [&](const std::set<int>& found) {
      std::ranges::copy_if(found, std::inserter(unknowns, unknowns.end()),
                           [&](int unknown) { return !others.contains(unknown); });
    };
    for (const std::size_t piece : group) take(of_piece_[piece]);
    for (bool grows = true; grows;) {
      grows = false;
      for (std::size_t e = 0; e < of_equation_.size(); ++e) {
        if (!is_stated_[e] || !meets(of_equation_[e], unknowns)) continue;
        if (!equations.insert(static_cast<int>(e)).second) continue;
        take(of_equation_[e]);
        grows = true;
      }
    }
    PlacingStep step = named(group);
    step.unknowns.assign(unknowns.begin(), unknowns.end());
    step.equations.assign(equations.begin(), equations.end());
    return step;
  }

  PlacingStep named(const Group& group) const {
    PlacingStep step;
    std::vector<std::string> names;
    for (const std::size_t piece : group) {
      const Piece& of = pieces_.all[piece];
      names.push_back(of.name);
      step.entities.insert(step.entities.end(), of.entities.begin(), of.entities.end());
      step.bodies += piece < pieces_.bodies ? 1 : 0;
    }
    step.name = enumeration(names);
    return step;
  }

  /// Equations of degree two in the step's unknowns.
  int quadratic(const PlacingStep& step) const {
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
  Pieces pieces_;
  std::vector<std::set<int>> of_piece_, of_equation_;
  std::vector<bool> is_stated_;
  std::vector<PlacingStep> steps_;
};

}  // namespace

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

std::set<int> unknowns_of(const QuadraticEquation& equation) {
  std::set<int> unknowns;
  for (const FormProduct& product : equation.products) {
    unknowns.merge(unknowns_of(product.left));
    unknowns.merge(unknowns_of(product.right));
  }
  return unknowns;
}

int turnings(const SignMasks& masks) {
  SignMasks turned;
  for (const SignMask mask : masks) turned.push_back(mask & ~(first_turning - 1));
  return turned.rank();
}

bool meets(const std::set<int>& a, const std::set<int>& b) {
  return std::ranges::any_of(a, [&](int i) { return b.contains(i); });
}

std::set<int> framing_points(const Scene& scene) {
  if (scene.is_anchored() || scene.problem().reference_body >= 0) return {};
  const Reference& frame = scene.reference();
  std::set<int> points{frame.origin, frame.axis, frame.plane};
  if (frame.line < 0 && scene.problem().is_point(frame.height)) points.insert(frame.height);
  points.erase(-1);
  return points;
}

std::vector<PlacingStep> placing_steps(const SceneSystem& system, Taken taken) {
  return Taking(system, taken).run();
}

}  // namespace gcs
