#pragma once
/// The formats of instances, and which fields each of them has.

#include "solvers/reading/json_cursor.hpp"

namespace gcs {

/// gcsbench-instance/1 has points, lines in space and distances between them; gcsbench-instance/2 has planes, bodies
/// and all types of constraints, too.
enum class InstanceFormat { distances, general };

/// What to do where a file uses what only gcsbench-instance/2 has, besides `otherwise`.
std::string general_format_remedy(const std::string& otherwise = {});

InstanceFormat read_format(const JsonCursor& root);

/// The instance has no field that its format does not have.
void check_fields(const JsonCursor& root, InstanceFormat format);

}  // namespace gcs
