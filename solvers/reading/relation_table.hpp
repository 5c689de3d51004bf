#pragma once
/// Which constraints there are, and between what.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// The type of that name in gcsbench-instance/2.
std::optional<RelationType> relation_type(const std::string& name);
std::string name_of(RelationType type);
/// The member that says the value; empty where there is none.
std::string name_of(Relation::Form form);
std::vector<std::string> relation_type_names();

/// Whether the type is between two operands; otherwise it is between points, any number of them or, of an orientation,
/// one more than the dimension.
bool is_of_pair(RelationType type);

/// Whether it says nothing in the plane.
bool is_only_in_space(RelationType type);

/// The kinds of operands, in any order, that the type can be between in that dimension. Precondition: it is of a pair.
std::vector<std::pair<OperandKind, OperandKind>> pairs_of(RelationType type, int dimension);

/// "point–line".
std::string words(const std::pair<OperandKind, OperandKind>& pair);

/// Of points, from the first to the last; of segments both.
std::vector<int> entities_of(const std::vector<Operand>& operands);

/// "'p1', 'L' and 'p2–p3'".
std::string operand_names(const ProblemStatement& problem, const std::vector<Operand>& operands);

/// A segment as it is whichever end comes first.
Operand undirected(const Operand& operand);

}  // namespace gcs
