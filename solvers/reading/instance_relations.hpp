#pragma once
/// One constraint of an instance: what it is, between what, and the value that it gives.

#include <map>
#include <utility>
#include <vector>

#include "solvers/reading/instance_format.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Reads one of `constraints`. Distances between points are read as a relation, too. `place`: in the list, from 1.
/// Refused: types and pairs that the format does not know, operands that are the same, all fixed or in one body, and
/// values that the type cannot have. Precondition: entities, bodies and `fixed` are read.
Relation read_relation(const JsonCursor& constraint, std::size_t place, InstanceFormat format,
                       const ProblemStatement& problem);

/// Which lines, segments and planes the `parallel` constraints of a problem make parallel.
class ParallelClasses {
 public:
  explicit ParallelClasses(const ProblemStatement& problem);

  bool joins(const Operand& a, const Operand& b) const;

 private:
  using Key = std::pair<int, int>;

  int class_of(const Operand& operand) const;
  void join(const Operand& a, const Operand& b);

  std::map<Key, int> classes_;
  std::vector<std::pair<Operand, Operand>> across_;  ///< of a direction and a plane
};

/// Whether a relation has a meaning only where a `parallel` joins its operands.
bool needs_parallel(const ProblemStatement& problem, Relation relation);

}  // namespace gcs
