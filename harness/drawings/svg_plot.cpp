#include "harness/drawings/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <tuple>

#include "harness/base/text_width.hpp"
#include "harness/drawings/html_text.hpp"

namespace gcs {
namespace {

// In points; 85 mm are 241 points.
constexpr double width = 241;
constexpr double inner_height = 136;
constexpr double right = 12, bottom = 32;
constexpr double font = 8;
constexpr double legend_line = 10;
constexpr double mean_letter = 4.4, legend_mark_width = 22;

/// Of Okabe and Ito (2008).
constexpr std::string_view blue = "#0072B2", vermillion = "#D55E00", black = "#000000";
constexpr std::array<std::string_view, 8> style_colours{blue,      vermillion, "#009E73", "#CC79A7",
                                                        "#E69F00", "#56B4E9",  black,     "#7F7F7F"};
/// Lengths of dashes and gaps.
constexpr std::array<std::string_view, 4> style_dashes{"", "5 2", "1.5 1.5", "6 1.5 1.5 1.5"};

std::string_view colour_of(const PlotSeries& series) {
  switch (series.mark) {
    case PlotMark::dot:
      return blue;
    case PlotMark::circle:
      return vermillion;
    case PlotMark::line:
      return black;
    case PlotMark::curve:
    case PlotMark::symbol:
    case PlotMark::steps:
      break;
  }
  return style_colours[static_cast<std::size_t>(series.style) % style_colours.size()];
}

/// Those that the legend names.
std::vector<const PlotSeries*> labelled(const Plot& plot) {
  std::vector<const PlotSeries*> series;
  for (const PlotSeries& one : plot.series)
    if (!one.label.empty()) series.push_back(&one);
  return series;
}

/// As many as fit side by side.
int legend_columns(const Plot& plot, double room) {
  double widest = 1;
  for (const PlotSeries* series : labelled(plot))
    widest =
        std::max(widest, legend_mark_width + mean_letter * static_cast<double>(display_width(series->label)));
  return std::clamp(static_cast<int>(room / widest), 1, std::max(1, static_cast<int>(labelled(plot).size())));
}

/// Places on the page of places on the axes.
struct Canvas {
  explicit Canvas(const Plot& shown)
      : plot(shown),
        left(shown.y.has_decades ? 48 : 34),
        columns(legend_columns(shown, width - left - right)),
        top(12 + legend_line * std::ceil(static_cast<double>(labelled(shown).size()) / columns)),
        height(top + inner_height + bottom) {}

  const Plot& plot;
  double left;
  int columns;  ///< of the legend
  double top;
  double height;

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
                     html_escaped(text));
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
  const auto [left, height, top] = std::tuple(canvas.left, canvas.height, canvas.top);
  std::string text = "<g fill=\"none\" stroke=\"#000000\" stroke-width=\"0.6\">\n";
  text += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, top,
                      width - left - right, height - top - bottom);
  for (const double tick : ticks_of(canvas.plot.x))
    text += segment(canvas.x(tick), height - bottom, canvas.x(tick), height - bottom + 3);
  for (const double tick : ticks_of(canvas.plot.y))
    text += segment(left, canvas.y(tick), left - 3, canvas.y(tick));
  return text + "</g>\n";
}

/// The text of a tick as SVG.
std::string tick_text(const PlotAxis& axis, double tick) {
  const std::string number = fmt::format("{:.6g}", tick);
  if (!axis.has_decades) return number;
  return "10<tspan dy=\"-3\" font-size=\"6\">" + (tick < 0 ? "−" + number.substr(1) : number) + "</tspan>";
}

std::string tick_at(double x, double y, std::string_view anchor, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, text);
}

std::string axis_labels(const Canvas& canvas) {
  const auto [left, height, top] = std::tuple(canvas.left, canvas.height, canvas.top);
  std::string text;
  for (const double tick : ticks_of(canvas.plot.x))
    text += tick_at(canvas.x(tick), height - bottom + 11, "middle", tick_text(canvas.plot.x, tick));
  for (const double tick : ticks_of(canvas.plot.y))
    text += tick_at(left - 5, canvas.y(tick) + 2.8, "end", tick_text(canvas.plot.y, tick));
  const double middle_y = top + (height - top - bottom) / 2;
  text += text_at(left + (width - left - right) / 2, height - 7, "middle", canvas.plot.x.label);
  return text + text_at(10, middle_y, "middle", canvas.plot.y.label,
                        fmt::format(" transform=\"rotate(-90 10 {:.1f})\"", middle_y));
}

// ---- marks

/// Shapes as paths about (0, 0), in the order of the styles.
constexpr std::array<std::string_view, 8> style_shapes{"m-2 0a2 2 0 1 0 4 0a2 2 0 1 0 -4 0z",
                                                       "m-1.8 -1.8h3.6v3.6h-3.6z",
                                                       "m0 -2.4l2.2 3.9h-4.4z",
                                                       "m0 -2.6l2.2 2.6l-2.2 2.6l-2.2 -2.6z",
                                                       "m-1.8 -1.8l3.6 3.6m0 -3.6l-3.6 3.6",
                                                       "m-2.4 0h4.8m-2.4 -2.4v4.8",
                                                       "m0 2.4l2.2 -3.9h-4.4z",
                                                       "m-1.8 -1.8h3.6l-3.6 3.6h3.6z"};

bool is_connected(PlotMark mark) {
  return mark == PlotMark::line || mark == PlotMark::curve || mark == PlotMark::steps;
}

/// What a mark's path has beside its shape.
std::string pen_of(const PlotSeries& series) {
  const std::string stroke = fmt::format("stroke=\"{}\"", colour_of(series));
  const std::string_view dashes = style_dashes[static_cast<std::size_t>(series.style) % style_dashes.size()];
  switch (series.mark) {
    case PlotMark::dot:
      return "fill=\"none\" stroke-width=\"0.9\" stroke-linecap=\"round\" " + stroke;
    case PlotMark::circle:
      return "fill=\"none\" stroke-width=\"1\" " + stroke;
    case PlotMark::line:
      return "fill=\"none\" stroke-width=\"0.8\" stroke-dasharray=\"4 2\" " + stroke;
    case PlotMark::curve:
      return "fill=\"none\" stroke-width=\"0.9\" stroke-linejoin=\"round\" " + stroke;
    case PlotMark::steps:
      return fmt::format("fill=\"none\" stroke-width=\"1\" stroke-dasharray=\"{}\" {}", dashes, stroke);
    case PlotMark::symbol:
      return fmt::format("fill=\"{}\" fill-opacity=\"0.35\" stroke-width=\"0.8\" {}", colour_of(series),
                         stroke);
  }
  return stroke;
}

std::string_view shape_of(const PlotSeries& series) {
  switch (series.mark) {
    case PlotMark::dot:
      return "h0";
    case PlotMark::circle:
      return "m-2.2 0a2.2 2.2 0 1 0 4.4 0a2.2 2.2 0 1 0 -4.4 0z";
    default:
      return style_shapes[static_cast<std::size_t>(series.style) % style_shapes.size()];
  }
}

/// The way from one point to the next: straight, or along and then up or down.
std::string way_to(const PlotSeries& series, double x, double y) {
  if (series.mark == PlotMark::steps) return fmt::format("H{:.1f}V{:.1f}", x, y);
  return fmt::format("L{:.1f} {:.1f}", x, y);
}

std::string marks(const Canvas& canvas, const PlotSeries& series) {
  std::string path;
  for (const PlotPoint& p : series.points) {
    if (!canvas.shows(p)) continue;
    const double x = canvas.x(p[0]), y = canvas.y(p[1]);
    if (is_connected(series.mark) && !path.empty())
      path += way_to(series, x, y);
    else
      path += fmt::format("M{:.1f} {:.1f}{}", x, y, is_connected(series.mark) ? "" : shape_of(series));
  }
  return fmt::format("<path {} d=\"{}\"/>\n", pen_of(series), path);
}

/// Beside their places, where none lies over another, as far as that is possible around one place.
std::string labels(const Canvas& canvas) {
  constexpr double line = 8;
  constexpr std::array<PlotPoint, 8> offsets{
      {{4, -3}, {-4, -3}, {4, 9}, {-4, 9}, {15, 3}, {-15, 3}, {15, -9}, {-15, -9}}};
  std::vector<PlotPoint> taken;
  std::string text;
  for (const PlotLabel& label : canvas.plot.labels) {
    const double length = mean_letter * static_cast<double>(display_width(label.text));
    const auto place = [&](const PlotPoint& offset) {
      const double left = offset[0] < 0 ? offset[0] - length : offset[0];
      return PlotPoint{canvas.x(label.at[0]) + left, canvas.y(label.at[1]) + offset[1]};
    };
    const auto is_free = [&](const PlotPoint& offset) {
      const PlotPoint p = place(offset);
      return p[0] > canvas.left && p[0] + length < width - right && p[1] - line > canvas.top &&
             std::none_of(taken.begin(), taken.end(), [&](const PlotPoint& other) {
               return std::abs(p[0] - other[0]) < length && std::abs(p[1] - other[1]) < line;
             });
    };
    const auto* const found = std::find_if(offsets.begin(), offsets.end(), is_free);
    taken.push_back(place(found == offsets.end() ? offsets.front() : *found));
    text += text_at(taken.back()[0], taken.back()[1], "start", label.text,
                    " paint-order=\"stroke\" stroke=\"#FFFFFF\" stroke-width=\"2\"");
  }
  return text;
}

/// The mark of a series on its own: 14 points wide, around (x, y).
std::string legend_mark(const PlotSeries& series, double x, double y) {
  if (is_connected(series.mark))
    return fmt::format("<path {} d=\"M{:.1f} {:.1f}h14\"/>\n", pen_of(series), x - 7, y);
  if (series.mark == PlotMark::dot)
    return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1\" fill=\"{}\"/>\n", x, y,
                       colour_of(series));
  return fmt::format("<path {} d=\"M{:.1f} {:.1f}{}\"/>\n", pen_of(series), x, y, shape_of(series));
}

/// Above the frame, row by row in columns of equal width.
std::string legend(const Canvas& canvas) {
  std::string text;
  const std::vector<const PlotSeries*> series = labelled(canvas.plot);
  const auto columns = static_cast<std::size_t>(canvas.columns);
  for (std::size_t i = 0; i < series.size(); ++i) {
    const double column = (width - canvas.left - right) / canvas.columns;
    const double x = canvas.left + static_cast<double>(i % columns) * column + 7;
    const double y = 11.5 + legend_line * static_cast<double>(i / columns);
    text += legend_mark(*series[i], x, y);
    text += text_at(x + 10, y + 2.5, "start", series[i]->label);
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

PlotAxis decades_over(std::string label, double low, double high) {
  double tick = 1;
  for (const double step : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0})
    if ((high - low) / tick > 5) tick = step;
  const double first = tick * std::floor(low / tick);
  return {std::move(label), first, std::max(first + tick, tick * std::ceil(high / tick)), tick, true};
}

std::string to_svg(const Plot& plot) {
  const Canvas canvas(plot);
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"85mm\" height=\"{:.1f}mm\" viewBox=\"0 0 {} {}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{}\" role=\"img\">\n<title>{}</title>\n",
      85 * canvas.height / width, width, canvas.height, font, html_escaped(plot.description));
  text += fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"#FFFFFF\"/>\n", width, canvas.height);
  for (const PlotSeries& series : plot.series) text += marks(canvas, series);
  return text + labels(canvas) + frame_of(canvas) + axis_labels(canvas) + legend(canvas) + "</svg>\n";
}

}  // namespace gcs
