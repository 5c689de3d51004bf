#pragma once
/// What files call their formats, for those who write and those who read them.

#include <string_view>

namespace gcs {

inline constexpr std::string_view path_format = "gcsbench-path/1";
inline constexpr std::string_view reference_format = "gcsbench-reference/1";
inline constexpr std::string_view result_format = "gcsbench-result/1";

}  // namespace gcs
