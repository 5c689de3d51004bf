#pragma once
/// What messages call constraints and what they are between.

#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// The member that says the value; empty where there is none.
std::string name_of(Relation::Form form);

/// "point–line".
std::string words(const std::vector<OperandKind>& kinds);

/// Of points, from the first to the last; of segments both.
std::vector<int> entities_of(const std::vector<Operand>& operands);

/// "'p1', 'L' and 'p2–p3'".
std::string operand_names(const ProblemStatement& problem, const std::vector<Operand>& operands);

/// A segment as it is whichever end comes first.
Operand undirected(const Operand& operand);

}  // namespace gcs
