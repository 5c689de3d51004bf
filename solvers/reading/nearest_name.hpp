#pragma once
/// "Did you mean": the valid name closest to a misspelt one.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gcs {

/// The name with the smallest number of insertions, deletions and replacements, upper and lower case being
/// alike; the first of several. Empty when there are no names.
std::string nearest_name(std::string_view misspelt, std::span<const std::string> names);

/// "'a', 'b' and 'c'".
std::string quoted_list(std::span<const std::string> names);

}  // namespace gcs
