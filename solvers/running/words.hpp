#pragma once
/// Words that reasons are made of.

#include <cstdint>
#include <string>

namespace gcs {

/// "1 path", "2 paths"
inline std::string counted(std::int64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// What a reason says of coordinates that lose the distances (residual_and_condition.hpp).
inline std::string too_large_for_doubles() {
  return "so large beside the lengths that doubles do not hold the distances";
}

}  // namespace gcs
