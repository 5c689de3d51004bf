#include "harness/drawings/configurations_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "harness/drawings/html_text.hpp"

namespace gcs {
namespace {

// In points; 85 mm are 241 points.
constexpr double panel = configuration_panel, width = 3 * panel, margin = 9, heading = 11, font = 7,
                 name_distance = 6.5;

/// From the plane to a panel whose upper left corner is `corner`: one scale for all, each figure in the
/// middle.
class PanelView {
 public:
  PanelView(const Figure& figure, double scale, const Eigen::Vector2d& corner)
      : scale_(scale), page_(corner + Eigen::Vector2d(panel / 2, heading + (panel - heading) / 2)) {
    const auto points = figure.points.topRows<2>();
    middle_ = (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
  }

  Eigen::Vector2d operator()(const Eigen::Vector2d& p) const {
    return page_ + scale_ * Eigen::Vector2d(p.x() - middle_.x(), middle_.y() - p.y());
  }
  double scale() const { return scale_; }

 private:
  double scale_;
  Eigen::Vector2d page_, middle_;
};

double extent(const Figure& figure) {
  const auto points = figure.points.topRows<2>();
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).maxCoeff();
}

std::string segment(const Eigen::Vector2d& a, const Eigen::Vector2d& b, bool is_arrow) {
  std::string text = fmt::format(
      "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"{}/>\n", a.x(), a.y(), b.x(), b.y(),
      is_arrow ? " class=\"removed\" stroke=\"#D55E00\" stroke-dasharray=\"3 2\"" : " class=\"edge\"");
  if (!is_arrow || (b - a).norm() < 1) return text;
  const Eigen::Vector2d along = 4 * (b - a).normalized(),
                        aside = 0.45 * Eigen::Vector2d(-along.y(), along.x());
  for (const auto& [tip, back] : {std::pair{a, along}, std::pair{b, Eigen::Vector2d(-along)}}) {
    const Eigen::Vector2d one = tip + back + aside, other = tip + back - aside;
    text += fmt::format(
        "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}\" fill=\"none\" stroke=\"#D55E00\"/>\n",
        one.x(), one.y(), tip.x(), tip.y(), other.x(), other.y());
  }
  return text;
}

std::string circle_svg(const DrawnCircle& circle, const PanelView& view) {
  const Eigen::Vector2d c = view(circle.centre);
  return fmt::format(
      "<circle class=\"construction\" cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"{2:.1f}\" fill=\"none\" "
      "stroke=\"#0072B2\" "
      "stroke-dasharray=\"2 1.6\"/>\n<path d=\"M{0:.1f} {1:.1f}m-1.6 0h3.2m-1.6 -1.6v3.2\" "
      "stroke=\"#0072B2\"/>\n",
      c.x(), c.y(), view.scale() * circle.radius);
}

/// Of a point: away from those that it is constrained against, upwards where they are all around.
template <typename Place>
Eigen::Vector2d open_direction(const ProblemStatement& problem, int point, const Place& place) {
  Eigen::Vector2d sum(0, 1e-3);
  for (const DistanceConstraint& c : problem.constraints)
    for (const std::size_t end : {0, 1})
      if (c.between[end] == point && problem.is_point(c.between[1 - end]))
        sum += (place(c.between[1 - end]) - place(point)).stableNormalized();
  return -sum.normalized();
}

std::string panel_svg(const ProblemStatement& problem, const Configuration& shown, const PanelView& view,
                      const Eigen::Vector2d& corner) {
  const auto place = [&](int point) { return view(shown.figure.points.col(point).head<2>()); };
  std::string text = fmt::format(
      "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{2:.1f}\" viewBox=\"{0:.1f} {1:.1f} "
      "{2:.1f} "
      "{2:.1f}\"><g stroke=\"#222222\" stroke-width=\"0.8\">\n",
      corner.x() + 1, corner.y(), panel - 2);
  for (const DrawnCircle& circle : shown.circles) text += circle_svg(circle, view);
  for (std::size_t c = 0; c < problem.constraints.size(); ++c) {
    const auto& [a, b] = problem.constraints[c].between;
    text += segment(place(a), place(b), shown.arrows.count(static_cast<int>(c)) > 0);
  }
  text += "</g></svg>\n";
  // Over the names, whose rims would cut into them.
  std::string discs;
  for (int i = 0; i < static_cast<int>(problem.points.size()); ++i) {
    const Eigen::Vector2d p = place(i);
    const Eigen::Vector2d name = p + name_distance * open_direction(problem, i, place);
    text += fmt::format(
        "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" stroke=\"#FFFFFF\" stroke-width=\"1.6\" "
        "paint-order=\"stroke\">{}</text>\n",
        name.x(), name.y() + font / 3, html_escaped(problem.points[static_cast<std::size_t>(i)]));
    discs += fmt::format("<circle class=\"point\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"1.7\" fill=\"#000000\"/>\n",
                         p.x(), p.y());
  }
  return text + discs +
         fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-weight=\"bold\">{}</text>\n", corner.x() + 4,
                     corner.y() + 8, html_escaped(shown.label));
}

}  // namespace

std::string configuration_panels(const ProblemStatement& problem,
                                 const std::vector<Configuration>& configurations, int columns,
                                 const Eigen::Vector2d& corner) {
  double largest = 0;
  for (const Configuration& one : configurations) largest = std::max(largest, extent(one.figure));
  const double scale = (panel - heading - 2 * margin) / largest;
  std::string text;
  for (std::size_t i = 0; i < configurations.size(); ++i) {
    const auto row = static_cast<int>(i) / columns, column = static_cast<int>(i) % columns;
    const Eigen::Vector2d at = corner + panel * Eigen::Vector2d(column, row);
    text += panel_svg(problem, configurations[i], PanelView(configurations[i].figure, scale, at), at);
  }
  return text;
}

std::string configurations_svg(const ProblemStatement& problem,
                               const std::vector<Configuration>& configurations, const std::string& title) {
  const double height = panel * std::ceil(static_cast<double>(configurations.size()) / 3);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"85mm\" height=\"{:.1f}mm\" viewBox=\"0 0 {} "
             "{:.1f}\" "
             "font-family=\"Helvetica, Arial, sans-serif\" font-size=\"{}\" "
             "role=\"img\">\n<title>{}</title>\n"
             "<rect width=\"{}\" height=\"{:.1f}\" fill=\"#FFFFFF\"/>\n",
             85 * height / width, width, height, font, html_escaped(title), width, height) +
         configuration_panels(problem, configurations, 3, Eigen::Vector2d::Zero()) + "</svg>\n";
}

}  // namespace gcs
