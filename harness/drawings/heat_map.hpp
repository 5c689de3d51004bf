#pragma once
/// A table of coloured fields as SVG, for one column of a paper, in colours that colour-blind readers can
/// tell apart.

#include <string>
#include <vector>

namespace gcs {

struct HeatMapRow {
  std::string label;        ///< of a row of fields, or of the block that begins here when there are no fields
  std::vector<int> fields;  ///< numbers of classes; −1: blank
  std::vector<std::string> captions = {};  ///< of the fields below, where a block begins
};

struct HeatMap {
  std::string description;  ///< for readers who cannot see it
  struct Class {
    std::string label;
    std::string colour;
    bool is_crossed = false;  ///< marked by a cross too
  };
  std::vector<Class> classes;  ///< in the order of the legend
  std::vector<HeatMapRow> rows;
};

/// The whole SVG document. Equal maps give equal text.
std::string to_svg(const HeatMap& map);

}  // namespace gcs
