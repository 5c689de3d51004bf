#pragma once
/// A drawing on its way to a file or a page.

#include <string>

namespace gcs {

/// A figure as the text of a file <name>.svg.
struct Drawing {
  std::string name;
  std::string svg;
  std::string caption;
};

}  // namespace gcs
