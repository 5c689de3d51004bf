#pragma once
/// A plot as SVG: for one column of a paper (85 mm wide), in colours that colour-blind readers can tell apart
/// and with marks that differ in shape too.

#include <array>
#include <string>
#include <vector>

namespace gcs {

using PlotPoint = std::array<double, 2>;  ///< in the units of the axes

/// How a series is drawn. `line` connects its points by dashes, `curve` without gaps and `steps` by a
/// staircase; `symbol` is one of eight shapes.
enum class PlotMark { dot, circle, line, curve, symbol, steps };

struct PlotSeries {
  std::string label;  ///< empty: not in the legend
  PlotMark mark = PlotMark::dot;
  std::vector<PlotPoint> points;
  int style = 0;  ///< of symbols, curves and steps: the number of the colour, and of the shape or the dashes
};

/// A word beside a place.
struct PlotLabel {
  PlotPoint at;
  std::string text;
};

struct PlotAxis {
  std::string label;  ///< with the unit
  double low = 0;
  double high = 1;
  double tick = 1;           ///< distance of two ticks, which lie at its multiples
  bool has_decades = false;  ///< values are decimal logarithms; ticks show the powers of ten
};

struct Plot {
  std::string description;  ///< for readers who cannot see it
  PlotAxis x, y;
  std::vector<PlotSeries> series;  ///< later ones are drawn over earlier ones
  std::vector<PlotLabel> labels{};
};

/// An axis that covers [low, high] from tick to tick, with about five ticks at multiples of 1, 2 or 5 times a
/// power of ten. Precondition: low < high.
PlotAxis axis_over(std::string label, double low, double high);

/// An axis of decimal logarithms over [low, high], with at most six ticks at whole ones.
/// Precondition: low <= high.
PlotAxis decades_over(std::string label, double low, double high);

/// The whole SVG document. Points outside the axes are left out. Equal plots give equal text.
std::string to_svg(const Plot& plot);

}  // namespace gcs
