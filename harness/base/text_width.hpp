#pragma once
/// How wide text is.

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace gcs {

/// Number of code points: the width on a terminal of the characters that tables use.
inline std::size_t display_width(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace gcs
