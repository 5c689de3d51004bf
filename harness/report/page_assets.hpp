#pragma once
/// The files of harness/report/page, which CMake puts into the program.

#include <string_view>

namespace gcs {

extern const std::string_view page_style;   ///< CSS
extern const std::string_view page_script;  ///< JavaScript, all files in order

}  // namespace gcs
