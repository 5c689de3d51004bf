#pragma once
/// From the names in an instance to the numbers in a ProblemStatement. Unknown names are an InputError with the
/// nearest valid one.

#include <optional>
#include <vector>

#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// What to do about a name of two elements.
inline constexpr const char* distinct_names = "points, lines, planes and bodies need different names";

/// The point that the cursor's text names; another element is refused by name.
int point_number(const ProblemStatement& problem, const JsonCursor& cursor);
/// The line that the cursor's text names; another element is refused by name.
int line_number(const ProblemStatement& problem, const JsonCursor& cursor);
/// The point, line or plane called `name`, as numbered in DistanceConstraint; the cursor is for the complaint.
int entity_number(const ProblemStatement& problem, const std::string& name, const JsonCursor& cursor);
/// The constraint of that id, if there is one.
std::optional<int> constraint_number(const ProblemStatement& problem, const std::string& id);
/// Ids of all constraints, in order.
std::vector<std::string> constraint_ids(const ProblemStatement& problem);

/// The body that the cursor's text names.
int body_number(const ProblemStatement& problem, const JsonCursor& cursor);

[[noreturn]] void refuse_planes_in_the_plane(const JsonCursor& planes);

/// "'p1', 'p2' and 'L'".
std::string entity_names(const ProblemStatement& problem, const std::vector<int>& entities);

}  // namespace gcs
