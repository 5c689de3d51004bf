#pragma once
/// Words that reasons are made of.

#include <cstdint>
#include <string>
#include <vector>

namespace gcs {

/// "1 path", "2 paths"
inline std::string counted(std::int64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// "a", "a and b", "a, b and c".
inline std::string enumeration(const std::vector<std::string>& words) {
  std::string result;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) result += i + 1 == words.size() ? " and " : ", ";
    result += words[i];
  }
  return result;
}

/// What a reason says of coordinates that lose the distances (residual_and_condition.hpp).
inline std::string too_large_for_doubles() {
  return "so large beside the lengths that doubles do not hold the distances";
}

}  // namespace gcs
