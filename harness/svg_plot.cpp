#include "harness/svg_plot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string_view>

namespace gcs {
namespace {

// In points; 85 mm are 241 points.
constexpr double width = 241;
constexpr double height = 190;
constexpr double left = 34, right = 12, top = 22, bottom = 32;
constexpr double font = 8;

/// Of Okabe and Ito (2008), in the order of PlotMark.
constexpr std::array<std::string_view, 3> colours{"#0072B2", "#D55E00", "#000000"};

std::string_view colour_of(PlotMark mark) { return colours[static_cast<std::size_t>(mark)]; }

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else
      result += c;
  }
  return result;
}

/// Places on the page of places on the axes.
struct Canvas {
  const Plot& plot;

  double x(double value) const {
    return left + (value - plot.x.low) / (plot.x.high - plot.x.low) * (width - left - right);
  }
  double y(double value) const {
    return height - bottom - (value - plot.y.low) / (plot.y.high - plot.y.low) * (height - top - bottom);
  }
  bool shows(const PlotPoint& p) const {
    return p[0] >= plot.x.low && p[0] <= plot.x.high && p[1] >= plot.y.low && p[1] <= plot.y.high;
  }
};

std::string text_at(double x, double y, std::string_view anchor, std::string_view text,
                    std::string_view more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                     escaped(text));
}

std::string segment(double x1, double y1, double x2, double y2) {
  return fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>\n", x1, y1, x2, y2);
}

/// Multiples of the tick on the axis.
std::vector<double> ticks_of(const PlotAxis& axis) {
  std::vector<double> ticks;
  const double slack = 1e-9;  // of a tick: the ends of an axis are ticks in spite of rounding
  for (double k = std::ceil(axis.low / axis.tick - slack); k <= axis.high / axis.tick + slack; ++k)
    ticks.push_back(k * axis.tick + 0.0);  // 0, not −0
  return ticks;
}

std::string frame_of(const Canvas& canvas) {
  std::string text = "<g fill=\"none\" stroke=\"#000000\" stroke-width=\"0.6\">\n";
  text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, top,
                      width - left - right, height - top - bottom);
  for (const double tick : ticks_of(canvas.plot.x))
    text += segment(canvas.x(tick), height - bottom, canvas.x(tick), height - bottom + 3);
  for (const double tick : ticks_of(canvas.plot.y))
    text += segment(left, canvas.y(tick), left - 3, canvas.y(tick));
  return text + "</g>\n";
}

std::string axis_labels(const Canvas& canvas) {
  std::string text;
  for (const double tick : ticks_of(canvas.plot.x))
    text += text_at(canvas.x(tick), height - bottom + 11, "middle", fmt::format("{:.6g}", tick));
  for (const double tick : ticks_of(canvas.plot.y))
    text += text_at(left - 5, canvas.y(tick) + 2.8, "end", fmt::format("{:.6g}", tick));
  const double middle_y = top + (height - top - bottom) / 2;
  text += text_at(left + (width - left - right) / 2, height - 7, "middle", canvas.plot.x.label);
  return text + text_at(10, middle_y, "middle", canvas.plot.y.label,
                        fmt::format(" transform=\"rotate(-90 10 {:.1f})\"", middle_y));
}

/// One path for all: a dot is a line of no length with round ends.
std::string dots(const Canvas& canvas, const std::vector<PlotPoint>& points, double size) {
  std::string path;
  for (const PlotPoint& p : points)
    if (canvas.shows(p)) path += fmt::format("M{:.1f} {:.1f}h0", canvas.x(p[0]), canvas.y(p[1]));
  return fmt::format(
      "<path fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\" d=\"{}\"/>\n",
      colour_of(PlotMark::dot), size, path);
}

std::string circles(const Canvas& canvas, const std::vector<PlotPoint>& points) {
  std::string text =
      fmt::format("<g fill=\"none\" stroke=\"{}\" stroke-width=\"1\">\n", colour_of(PlotMark::circle));
  for (const PlotPoint& p : points)
    if (canvas.shows(p))
      text +=
          fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\"/>\n", canvas.x(p[0]), canvas.y(p[1]));
  return text + "</g>\n";
}

std::string line(const Canvas& canvas, const std::vector<PlotPoint>& points) {
  std::string path;
  for (const PlotPoint& p : points)
    if (canvas.shows(p))
      path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', canvas.x(p[0]), canvas.y(p[1]));
  return fmt::format(
      "<path fill=\"none\" stroke=\"{}\" stroke-width=\"0.8\" stroke-dasharray=\"4 2\" d=\"{}\"/>\n",
      colour_of(PlotMark::line), path);
}

std::string marks(const Canvas& canvas, const PlotSeries& series) {
  switch (series.mark) {
    case PlotMark::dot:
      return dots(canvas, series.points, 0.9);
    case PlotMark::circle:
      return circles(canvas, series.points);
    case PlotMark::line:
      return line(canvas, series.points);
  }
  return "";
}

/// The mark of a series on its own, for the legend: 14 points wide, around (x, y).
std::string legend_mark(PlotMark mark, double x, double y) {
  const std::string_view colour = colour_of(mark);
  switch (mark) {
    case PlotMark::dot:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1\" fill=\"{}\"/>\n", x, y, colour);
    case PlotMark::circle:
      return fmt::format(
          "<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.2\" fill=\"none\" stroke=\"{}\" stroke-width=\"1\"/>\n",
          x, y, colour);
    case PlotMark::line:
      return fmt::format(
          "<path stroke=\"{}\" stroke-width=\"0.8\" stroke-dasharray=\"4 2\" d=\"M{:.1f} {:.1f}h14\"/>\n",
          colour, x - 7, y);
  }
  return "";
}

/// Side by side above the frame, in columns of equal width.
std::string legend(const Plot& plot) {
  std::string text;
  const double column = (width - left - right) / static_cast<double>(plot.series.size());
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const double x = left + static_cast<double>(i) * column + 7;
    text += legend_mark(plot.series[i].mark, x, top - 10.5);
    text += text_at(x + 10, top - 8, "start", plot.series[i].label);
  }
  return text;
}

}  // namespace

PlotAxis axis_over(std::string label, double low, double high) {
  const double rough = (high - low) / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double tick = power;
  for (const double factor : {2.0, 5.0, 10.0})
    if (tick < rough) tick = factor * power;
  return {std::move(label), tick * std::floor(low / tick), tick * std::ceil(high / tick), tick};
}

std::string to_svg(const Plot& plot) {
  const Canvas canvas{plot};
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"85mm\" height=\"{:.1f}mm\" viewBox=\"0 0 {} {}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{}\" role=\"img\">\n<title>{}</title>\n",
      85 * height / width, width, height, font, escaped(plot.description));
  text += fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"#FFFFFF\"/>\n", width, height);
  for (const PlotSeries& series : plot.series) text += marks(canvas, series);
  return text + frame_of(canvas) + axis_labels(canvas) + legend(plot) + "</svg>\n";
}

}  // namespace gcs
