#include "solvers/counting/system_bound.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "solvers/elements/placing_steps.hpp"

namespace gcs {
namespace {

/// Of one sum over groups, and of all sums of a block: a fraction of a second.
constexpr std::size_t most_states = 5'000;
constexpr std::int64_t most_states_of_block = 500'000;
/// Of a group of signs of which all elements are looked at.
constexpr int most_generators = 12;

using Group = std::vector<int>;

/// Equations with as many unknowns, each matched to one.
struct Block {
  std::vector<int> equations;
  std::set<int> unknowns;
};

/// The finest division of a system into blocks that are solved one after the other (Dulmage, Mendelsohn 1958).
class BlockDivision {
 public:
  explicit BlockDivision(const QuadraticSystem& system)
      : equation_of_(static_cast<std::size_t>(system.unknowns), -1),
        unknown_of_(system.equations.size(), -1) {
    for (const QuadraticEquation& equation : system.equations) unknowns_.push_back(unknowns_of(equation));
  }

  /// Nothing where not every equation has an unknown of its own, or one is left over.
  std::optional<std::vector<Block>> blocks() {
    if (unknown_of_.size() != equation_of_.size()) return std::nullopt;
    for (std::size_t e = 0; e < unknown_of_.size(); ++e) {
      std::set<int> tried;
      if (!match(static_cast<int>(e), tried)) return std::nullopt;
    }
    number_.assign(unknown_of_.size(), -1);
    lowest_.assign(unknown_of_.size(), -1);
    for (std::size_t e = 0; e < unknown_of_.size(); ++e)
      if (number_[e] < 0) visit(static_cast<int>(e));
    return blocks_;
  }

 private:
  bool match(int equation, std::set<int>& tried) {
    for (const int unknown : unknowns_[static_cast<std::size_t>(equation)]) {
      if (!tried.insert(unknown).second) continue;
      int& owner = equation_of_[static_cast<std::size_t>(unknown)];
      if (owner >= 0 && !match(owner, tried)) continue;
      owner = equation;
      unknown_of_[static_cast<std::size_t>(equation)] = unknown;
      return true;
    }
    return false;
  }

  /// Strong components of equations that need each other's unknowns (Tarjan 1972).
  void visit(int equation) {
    const auto e = static_cast<std::size_t>(equation);
    number_[e] = lowest_[e] = visited_++;
    open_.push_back(equation);
    for (const int unknown : unknowns_[e]) {
      const int next = equation_of_[static_cast<std::size_t>(unknown)];
      const auto n = static_cast<std::size_t>(next);
      if (number_[n] < 0) {
        visit(next);
        lowest_[e] = std::min(lowest_[e], lowest_[n]);
      } else if (std::ranges::find(open_, next) != open_.end()) {
        lowest_[e] = std::min(lowest_[e], number_[n]);
      }
    }
    if (lowest_[e] != number_[e]) return;
    Block& block = blocks_.emplace_back();
    for (int last = -1; last != equation; open_.pop_back()) {
      last = open_.back();
      block.equations.push_back(last);
      block.unknowns.insert(unknown_of_[static_cast<std::size_t>(last)]);
    }
  }

  std::vector<std::set<int>> unknowns_;  ///< of each equation
  std::vector<int> equation_of_, unknown_of_;
  std::vector<int> number_, lowest_, open_;
  int visited_ = 0;
  std::vector<Block> blocks_;
};

/// The degree of an equation in the unknowns of a group.
int degree_in(const QuadraticEquation& equation, const Group& group) {
  const auto meets = [&](const LinearForm& form) {
    return std::ranges::any_of(
        form.terms, [&](const ScaledUnknown& term) { return std::ranges::count(group, term.unknown) > 0; });
  };
  int degree = 0;
  for (const FormProduct& product : equation.products)
    degree = std::max(degree, int{meets(product.left)} + int{meets(product.right)});
  return degree;
}

/// The coefficient of Π_j a_j^|group j| in Π_e Σ_j degree_ej a_j. Takes the states that it makes from `states_left`.
std::optional<Natural> bezout_number(const QuadraticSystem& system, const Block& block,
                                     const std::vector<Group>& groups, std::int64_t& states_left) {
  using Left = std::vector<int>;  // unknowns of each group that no equation has taken
  Left all;
  for (const Group& group : groups) all.push_back(static_cast<int>(group.size()));
  std::map<Left, Natural> ways{{all, Natural(1)}};
  for (const int e : block.equations) {
    std::map<Left, Natural> next;
    for (std::size_t j = 0; j < groups.size(); ++j) {
      const int degree = degree_in(system.equations[static_cast<std::size_t>(e)], groups[j]);
      if (degree == 0) continue;
      for (const auto& [left, count] : ways) {
        if (left[j] == 0) continue;
        Left fewer = left;
        --fewer[j];
        next[std::move(fewer)] += count * Natural(static_cast<std::uint64_t>(degree));
      }
    }
    states_left -= std::ssize(next);
    if (next.size() > most_states || states_left < 0) return std::nullopt;
    ways = std::move(next);
  }
  return ways.empty() ? Natural(0) : ways.begin()->second;
}

std::vector<Group> groups_in(const Block& block, const std::vector<Group>& groups) {
  std::vector<Group> result;
  std::set<int> left = block.unknowns;
  for (const Group& group : groups) {
    Group part;
    std::ranges::copy_if(group, std::back_inserter(part),
                         [&](int unknown) { return left.erase(unknown) > 0; });
    if (!part.empty()) result.push_back(std::move(part));
  }
  for (const int unknown : left) result.push_back({unknown});
  return result;
}

std::vector<Group> joined(std::vector<Group> groups, std::size_t i, std::size_t j) {
  groups[i].insert(groups[i].end(), groups[j].begin(), groups[j].end());
  groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(j));
  return groups;
}

/// By Bézout, or less by groups: by joining two of them while that is for the better, or counting takes too long.
Natural smallest_bezout_number(const QuadraticSystem& system, const Block& block, std::vector<Group> groups) {
  std::int64_t states_left = most_states_of_block;
  const Group all(block.unknowns.begin(), block.unknowns.end());
  const Natural of_one = bezout_number(system, block, {all}, states_left).value();
  std::optional<Natural> here = bezout_number(system, block, groups, states_left);
  const auto join = [&](std::size_t i, std::size_t j) {
    std::vector<Group> fewer = joined(groups, i, j);
    std::optional<Natural> number = bezout_number(system, block, fewer, states_left);
    if (here && !(number && *number < *here)) return false;
    groups = std::move(fewer);
    here = std::move(number);
    return true;
  };
  const auto join_any = [&] {
    std::ranges::sort(groups, {}, &Group::size);
    for (std::size_t i = 0; i < groups.size(); ++i)
      for (std::size_t j = i + 1; j < groups.size(); ++j)
        if (join(i, j)) return true;
    return false;
  };
  while (join_any()) {
  }
  return here ? std::min(of_one, *here) : of_one;
}

/// Vectors of the scene's elements, and what a description names beside them.
std::vector<Group> vectors_of(const SceneSystem& system) {
  const SystemBuilder& elements = system.elements();
  const ProblemStatement& problem = elements.problem();
  std::vector<Group> groups;
  const auto add = [&](const VectorForm& forms) {
    std::set<int> unknowns;
    for (const LinearForm& form : forms)
      for (const ScaledUnknown& term : form.terms) unknowns.insert(term.unknown);
    groups.emplace_back(unknowns.begin(), unknowns.end());
  };
  for (const NamedVector& vector : elements.named()) add(vector.forms);
  for (int entity = 0; entity < problem.entity_count(); ++entity) {
    if (problem.is_point(entity)) {
      add(elements.point(entity));
    } else if (problem.is_line(entity)) {
      add(elements.line(entity).direction);
      add(elements.line(entity).foot);
    } else {
      add(elements.plane(entity).normal);
    }
  }
  return groups;
}

/// What a change of signs makes of a system: of every unknown and equation whether it changes its sign.
class SignChange {
 public:
  SignChange(const QuadraticSystem& system, SignMask element) : system_(system) {
    for (const SignMask mask : system.mirror) changes_.push_back(std::popcount(mask & element) % 2 == 1);
  }

  bool is_identity() const { return std::ranges::count(changes_, true) == 0; }
  bool unknown(std::size_t i) const { return changes_[i]; }
  /// Σ products = given, of which all products keep their signs or all change them.
  bool equation(const QuadraticEquation& equation) const {
    for (const FormProduct& product : equation.products)
      if (!product.left.terms.empty() || !product.right.terms.empty())
        return form(product.left) != form(product.right);
    return false;
  }
  /// Whether no solution stays where it is: what would be left of an equation is 0 = 1.
  bool moves_all() const {
    return std::ranges::any_of(system_.equations, [&](const QuadraticEquation& equation) {
      return !equation.given.is_zero() &&
             std::ranges::all_of(equation.products, [&](const FormProduct& product) {
               return vanishes(product.left) || vanishes(product.right);
             });
    });
  }

 private:
  bool form(const LinearForm& form) const {
    return !form.terms.empty() && changes_[static_cast<std::size_t>(form.terms.front().unknown)];
  }
  /// Where the unknowns that change are 0.
  bool vanishes(const LinearForm& form) const {
    return form.constant.is_zero() && std::ranges::all_of(form.terms, [&](const ScaledUnknown& term) {
             return changes_[static_cast<std::size_t>(term.unknown)];
           });
  }

  const QuadraticSystem& system_;
  std::vector<bool> changes_;
};

/// Whether the Jacobian loses rank wherever the change leaves a solution in its place: equations and unknowns that change
/// their signs are not as many.
bool is_singular_where_fixed(const QuadraticSystem& system, const SignChange& change) {
  std::ptrdiff_t excess = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(system.unknowns); ++i) excess += change.unknown(i);
  for (const QuadraticEquation& equation : system.equations) excess -= change.equation(equation);
  return excess != 0;
}

/// The elements of the group, by the generators that they are made of, that may leave a solution in its place.
std::set<SignMask> fixing_elements(const QuadraticSystem& system) {
  std::set<SignMask> result;
  const SignMask generators = generators_of(system.mirror);
  for (SignMask element = generators; element != 0; element = (element - 1) & generators) {
    const SignChange change(system, element);
    if (!change.is_identity() && !change.moves_all()) result.insert(element);
  }
  return result;
}

/// The rank of a group of changes of signs by whose order the number of solutions is divided.
int dividing_rank(const QuadraticSystem& system) {
  if (std::popcount(generators_of(system.mirror)) > most_generators) return 0;
  const std::set<SignMask> fixing = fixing_elements(system);
  // Where two of them may leave a solution in its place the rank is not known to fall by two.
  const auto counts = [&](SignMask element) {
    return is_singular_where_fixed(system, SignChange(system, element)) &&
           std::ranges::none_of(fixing, [&](SignMask other) { return fixing.contains(element ^ other); });
  };
  if (std::ranges::all_of(fixing, counts)) return system.mirror.rank();
  const auto turns = [](SignMask element) { return element & ~(first_turning - 1); };
  if (std::ranges::any_of(fixing, [&](SignMask element) { return turns(element) == element; })) return 0;
  std::vector<SignMask> turnings;
  for (const SignMask mask : system.mirror) turnings.push_back(turns(mask));
  return SignMasks(std::move(turnings)).rank();
}

}  // namespace

std::optional<Natural> system_bound(const QuadraticSystem& system, const std::vector<Group>& groups) {
  const std::optional<std::vector<Block>> blocks = BlockDivision(system).blocks();
  if (!blocks) return std::nullopt;
  Natural bound(1);
  for (const Block& block : *blocks)
    bound = bound * smallest_bezout_number(system, block, groups_in(block, groups));
  return bound;
}

std::optional<Natural> class_bound(const QuadraticSystem& system, const std::vector<Group>& groups) {
  std::optional<Natural> bound = system_bound(system, groups);
  if (!bound) return std::nullopt;
  for (int rank = dividing_rank(system); rank > 0; --rank) bound = *bound / 2U;
  return bound;
}

bool divides_by_all(const QuadraticSystem& system) { return dividing_rank(system) == system.mirror.rank(); }

std::optional<Natural> class_bound(const SceneSystem& system) {
  return class_bound(system.equations(), vectors_of(system));
}

}  // namespace gcs
