#pragma once
/// Small figures of a plane scene side by side, as SVG for one column of a paper.

#include <Eigen/Core>
#include <set>
#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

struct DrawnCircle {
  Eigen::Vector2d centre;
  double radius = 0;
};

struct Configuration {
  std::string label;  ///< "(a) t = 1.2"
  Figure figure;
  std::set<int> arrows;              ///< constraints drawn as dashed double arrows
  std::vector<DrawnCircle> circles;  ///< dashed
};

/// Width and height of the panel of a figure, in points of 1/72 inch: a third of a column.
inline constexpr double configuration_panel = 241.0 / 3;

/// The panels alone, for a document in points: `columns` to a row, from `corner` on, all to one scale. The font is
/// the document's.
std::string configuration_panels(const ProblemStatement& problem,
                                 const std::vector<Configuration>& configurations, int columns,
                                 const Eigen::Vector2d& corner);

/// The whole SVG document, three figures to a row, all to one scale.
std::string configurations_svg(const ProblemStatement& problem,
                               const std::vector<Configuration>& configurations, const std::string& title);

}  // namespace gcs
