#pragma once
/// Finds instances by what a user calls them.

#include <string>
#include <vector>

#include "solvers/reading/instance_parser.hpp"

namespace gcs {

/// Loads and validates `argument`: a file when it has a '/' or ends in .json, "-" for standard input, a
/// member of a family when it has an '@' (families.hpp), anything else the id of a shipped instance, looked
/// up in ./instances and then where the program was built or installed. Checks as parse_instance does.
/// Throws InputError.
Instance load_instance(const std::string& argument);

/// Whether the shipped instance of that id, or the member of a family, says the same.
bool is_shipped(const Instance& instance);

/// Ids of all shipped instances, sorted.
std::vector<std::string> shipped_instances();

}  // namespace gcs
