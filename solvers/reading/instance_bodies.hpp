#pragma once
/// The part of an instance that gives elements in positions relative to each other: `bodies`.

#include <set>
#include <string>

#include "solvers/reading/element_position.hpp"
#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// Appends the elements that bodies name to the problem's points, lines and planes, in the order of the file; one that
/// two bodies name is one element. `taken`: all names so far, to which the new ones are added.
void append_body_elements(const JsonCursor& bodies, std::set<std::string>& taken, ProblemStatement& problem);

/// Reads `bodies` into the problem. Refused: a body whose elements do not determine its pose, bodies that share what
/// fixes both, and shared elements whose positions disagree. Precondition: their elements are among the problem's.
void read_bodies(const JsonCursor& bodies, ProblemStatement& problem);

/// Elements of a body that are fixed in positions that disagree with it are refused.
void check_fixed_bodies(const JsonCursor& fixed, const ProblemStatement& problem);

/// The index of a body that has all these entities, or −1.
int common_body(const ProblemStatement& problem, const std::vector<int>& entities);

}  // namespace gcs
