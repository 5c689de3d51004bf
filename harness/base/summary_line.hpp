#pragma once
/// The lines of a summary.

#include <fmt/format.h>

#include <string>
#include <string_view>

namespace gcs {

/// One indented line: a label and what it says.
inline std::string summary_line(std::string_view label, std::string_view text) {
  return fmt::format("  {:<14}{}\n", label, text);
}

}  // namespace gcs
