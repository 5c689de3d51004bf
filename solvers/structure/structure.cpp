#include "solvers/structure/structure.hpp"

#include <algorithm>
#include <cstdio>
#include <random>

#include "solvers/running/errors.hpp"
#include "solvers/running/words.hpp"
#include "solvers/structure/core_reduction.hpp"
#include "solvers/structure/length_inequalities.hpp"
#include "solvers/structure/loose_entities.hpp"
#include "solvers/structure/rigidity_matrix.hpp"

namespace gcs {
namespace {

std::string names_of(const ProblemStatement& problem, const std::vector<int>& entities) {
  std::vector<std::string> names;
  for (const int entity : entities) names.push_back(problem.name(entity));
  return enumeration(names);
}

/// "a1 (p1–p2)".
std::string described(const ProblemStatement& problem, int constraint) {
  const auto& [a, b] = problem.constraints[constraint].between;
  return problem.constraints[constraint].id + " (" + problem.name(a) + "–" + problem.name(b) + ")";
}

std::string described(const ProblemStatement& problem, const std::vector<int>& constraints) {
  std::vector<std::string> words;
  for (const int constraint : constraints) words.push_back(described(problem, constraint));
  return enumeration(words);
}

/// The smallest of the dependent sets of constraints that the elimination meets; every constraint in it can
/// be removed without making anything movable.
std::vector<int> dependent_set(const RigidityMatrix& matrix) {
  const int count = static_cast<int>(matrix.rows.size());
  std::vector<int> smallest;
  for (const ResidueVector& relation : null_space(transposed(matrix.rows, matrix.columns), count)) {
    std::vector<int> support;
    for (int i = 0; i < count; ++i) {
      if (!relation[i].is_zero()) support.push_back(i);
    }
    if (smallest.empty() || support.size() < smallest.size()) smallest = std::move(support);
  }
  return smallest;
}

/// Under-, over- or wrongly constrained.
class ConstraintCount {
 public:
  ConstraintCount(const ProblemStatement& problem, const RigidityMatrix& matrix, const Structure& structure,
                  std::mt19937_64& engine)
      : problem_(problem),
        missing_(structure.unknowns - structure.generic_rank),
        surplus_(structure.constraints - structure.generic_rank) {
    if (missing_ > 0) loose_ = loose_entities(matrix, engine);
    if (surplus_ > 0) dependent_ = dependent_set(matrix);
  }

  bool is_right() const { return missing_ == 0 && surplus_ == 0; }

  StructureDefect defect() const {
    using Kind = StructureDefect::Kind;
    const Kind kind = missing_ == 0   ? Kind::over_constrained
                      : surplus_ == 0 ? Kind::under_constrained
                                      : Kind::wrongly_constrained;
    return {kind, loose_, dependent_, what(kind), remedy(kind)};
  }

 private:
  std::string what(StructureDefect::Kind kind) const {
    switch (kind) {
      case StructureDefect::Kind::over_constrained:
        return "over-constrained: " + dependence();
      case StructureDefect::Kind::under_constrained:
        return "under-constrained: " + freedom();
      default:
        return "wrongly constrained: " + freedom() + ", while " + dependence();
    }
  }

  std::string remedy(StructureDefect::Kind kind) const {
    switch (kind) {
      case StructureDefect::Kind::over_constrained:
        return "remove " + counted(surplus_, "distance") + ", beginning with one of these";
      case StructureDefect::Kind::under_constrained:
        return "add " + counted(missing_, "distance") + " that hold" + (missing_ == 1 ? "s " : " ") +
               names_of(problem_, loose_);
      default:
        return "replace one of these distances by one that holds " + names_of(problem_, loose_);
    }
  }

  std::string freedom() const {
    return names_of(problem_, loose_) + " can move against the rest (" + counted(missing_, "degree") +
           " of freedom left)";
  }

  std::string dependence() const {
    return "at generic lengths the distances " + described(problem_, dependent_) +
           " contradict each other, because all but " + (surplus_ == 1 ? "one" : "some") +
           " of them determine the rest";
  }

  const ProblemStatement& problem_;
  int missing_;
  int surplus_;
  std::vector<int> loose_;
  std::vector<int> dependent_;
};

/// A double in as many digits as a person wants to read.
std::string readable(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

StructureDefect unsatisfiable(const ProblemStatement& problem, const ViolatedInequality& violated) {
  const std::string ends = names_of(problem, {violated.entities.front(), violated.entities.back()});
  const std::string length = violated.constraint >= 0 ? described(problem, violated.constraint) + " is "
                                                      : "the fixed " + ends + " are apart by ";
  return {StructureDefect::Kind::unsatisfiable, violated.entities, violated.constraints,
          "no figure has these lengths: " + length + readable(violated.length) + ", but the way over " +
              names_of(problem, violated.entities) + " is only " + readable(violated.other_way) + " long",
          "correct one of " + described(problem, violated.constraints)};
}

/// Of the rows of a hung point's constraints the columns of the point: regular at almost all placements.
ResidueMatrix own_block(const ProblemStatement& problem, const RigidityMatrix& matrix,
                        const PlacedPoint& placed, const std::vector<int>& incident) {
  ResidueMatrix block;
  const auto first = static_cast<std::size_t>(matrix.first_column[placed.point]);
  for (const int constraint : incident) {
    const auto& [a, b] = problem.constraints[constraint].between;
    const int other = a == placed.point ? b : a;
    if (std::find(placed.from.begin(), placed.from.end(), other) == placed.from.end()) continue;
    const ResidueVector& row = matrix.rows[constraint];
    block.emplace_back(row.begin() + static_cast<std::ptrdiff_t>(first),
                       row.begin() + static_cast<std::ptrdiff_t>(first) + problem.dimension);
  }
  return block;
}

/// The rank of the matrix, or a smaller number: with the columns of hung points last it is block triangular.
int generic_rank(const ProblemStatement& problem, const RigidityMatrix& matrix) {
  const CoreReduction reduction = reduce_to_core(problem, {}, HangsOn::points);
  ResidueMatrix core;
  for (const int constraint : reduction.core_constraints) core.push_back(matrix.rows[constraint]);
  std::vector<std::vector<int>> incident(problem.points.size() + problem.lines.size());
  for (int i = 0; i < static_cast<int>(problem.constraints.size()); ++i)
    for (const int entity : problem.constraints[i].between) incident[entity].push_back(i);
  int result = rank(std::move(core));
  for (const PlacedPoint& placed : reduction.placed)
    result += rank(own_block(problem, matrix, placed, incident[placed.point]));
  return result;
}

int unknown_count(const RigidityMatrix& matrix) { return matrix.columns - rank(matrix.trivial_motions); }

}  // namespace

Structure analyse_structure(const ProblemStatement& problem) {
  std::mt19937_64 engine(1);
  RigidityMatrix matrix = rigidity_matrix(problem, engine);
  Structure structure;
  structure.unknowns = unknown_count(matrix);
  structure.constraints = static_cast<int>(problem.constraints.size());
  structure.generic_rank = generic_rank(problem, matrix);
  if (structure.generic_rank < std::min(structure.unknowns, structure.constraints)) {
    RigidityMatrix second = rigidity_matrix(problem, engine);
    if (const int second_rank = generic_rank(problem, second); second_rank > structure.generic_rank) {
      structure.generic_rank = second_rank;
      matrix = std::move(second);
    }
  }
  const ConstraintCount count(problem, matrix, structure, engine);
  if (!count.is_right()) structure.defects.push_back(count.defect());
  for (const ViolatedInequality& violated : violated_inequalities(problem)) {
    structure.defects.push_back(unsatisfiable(problem, violated));
  }
  return structure;
}

void require_well_posed(const ProblemStatement& problem, const std::string& file) {
  if (problem.is_general()) return;
  const Structure structure = analyse_structure(problem);
  if (structure.well_posed()) return;
  const StructureDefect& defect = structure.defects.front();
  std::string pointer = "/constraints";
  if (defect.kind == StructureDefect::Kind::unsatisfiable)
    pointer += "/" + std::to_string(defect.constraints.front());
  throw InputError(file, pointer, defect.what, defect.remedy);
}

}  // namespace gcs
