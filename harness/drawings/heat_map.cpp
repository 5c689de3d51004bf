#include "harness/drawings/heat_map.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/drawings/html_text.hpp"

namespace gcs {
namespace {

// In points; 85 mm are 241 points.
constexpr double width = 241, left = 72, right = 4, line = 8.5, field_height = 7.5, font = 7;

std::string text_at(double x, double y, std::string_view anchor, std::string_view text,
                    bool is_bold = false) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor,
                     is_bold ? " font-weight=\"bold\"" : "", html_escaped(text));
}

std::string field_at(double x, double y, double field_width, const HeatMap::Class& one) {
  std::string text =
      fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n", x, y,
                  field_width - 1, field_height, one.colour);
  if (one.is_crossed)
    text += fmt::format(
        "<path d=\"M{0:.1f} {2:.1f}L{1:.1f} {3:.1f}M{0:.1f} {3:.1f}L{1:.1f} {2:.1f}\" stroke=\"#000000\" "
        "stroke-width=\"0.7\"/>\n",
        x + 2, x + field_width - 3, y + 1.5, y + field_height - 1.5);
  return text;
}

constexpr double caption_font = 4.5, widest_character = 0.6;

/// Over fields of that width.
bool fit(const std::vector<std::string>& captions, double field_width) {
  return std::ranges::all_of(captions, [=](const std::string& caption) {
    return widest_character * caption_font * static_cast<double>(caption.size()) <= field_width;
  });
}

std::string caption_over(double x, double y, const std::string& text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" font-size=\"{}\">{}</text>\n", x,
                     y, caption_font, html_escaped(text));
}

/// Two classes a line, above the map.
std::string legend(const HeatMap& map) {
  std::string text;
  for (std::size_t i = 0; i < map.classes.size(); ++i) {
    const double x = 8 + (i % 2 == 0 ? 0 : width / 2), y = 4 + line * static_cast<double>(i / 2);
    text += field_at(x, y, 12, map.classes[i]);
    text += text_at(x + 15, y + 6, "start", map.classes[i].label);
  }
  return text;
}

}  // namespace

std::string to_svg(const HeatMap& map) {
  const double top = 10 + line * static_cast<double>((map.classes.size() + 1) / 2);
  const double height = top + line * static_cast<double>(map.rows.size()) + 4;
  std::string text = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"85mm\" height=\"{:.1f}mm\" viewBox=\"0 0 {} "
      "{:.1f}\" "
      "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{}\" role=\"img\">\n<title>{}</title>\n"
      "<rect width=\"{}\" height=\"{:.1f}\" fill=\"#FFFFFF\"/>\n",
      85 * height / width, width, height, font, html_escaped(map.description), width, height);
  text += legend(map);
  std::size_t columns = 1;
  for (const HeatMapRow& row : map.rows) columns = std::max(columns, row.fields.size());
  const double field_width = (width - left - right) / static_cast<double>(columns);
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    const HeatMapRow& row = map.rows[r];
    const double y = top + line * static_cast<double>(r);
    if (row.fields.empty()) {
      text += text_at(4, y + 6.5, "start", row.label, true);
      if (fit(row.captions, field_width))
        for (std::size_t c = 0; c < row.captions.size(); ++c)
          text += caption_over(left + field_width * (static_cast<double>(c) + 0.5), y + 7, row.captions[c]);
      continue;
    }
    text += text_at(left - 4, y + 6.2, "end", row.label);
    for (std::size_t c = 0; c < row.fields.size(); ++c)
      if (row.fields[c] >= 0)
        text += field_at(left + field_width * static_cast<double>(c), y, field_width,
                         map.classes[static_cast<std::size_t>(row.fields[c])]);
  }
  return text + "</svg>\n";
}

}  // namespace gcs
