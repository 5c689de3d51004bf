#include "harness/drawings/path_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/drawings/svg_plot.hpp"

namespace gcs {
namespace {

/// More would hide the path.
constexpr std::size_t most_marked_changes = 100;

double value_of(const PathCorner& corner, const PathCoordinate& coordinate) {
  return corner.figure.points(coordinate.axis, coordinate.point);
}

std::array<double, 2> range_of(const StoredPath& path, const PathCoordinate& coordinate) {
  const auto [low, high] = std::minmax_element(path.corners.begin(), path.corners.end(),
                                               [&](const PathCorner& a, const PathCorner& b) {
                                                 return value_of(a, coordinate) < value_of(b, coordinate);
                                               });
  return {value_of(*low, coordinate), value_of(*high, coordinate)};
}

double width_of(const StoredPath& path, const PathCoordinate& coordinate) {
  const auto [low, high] = range_of(path, coordinate);
  return high - low;
}

}  // namespace

std::vector<PathCoordinate> moving_coordinates(const StoredPath& path, int dimension) {
  std::vector<PathCoordinate> moving;
  for (int point = 0; point < static_cast<int>(path.corners.front().figure.points.cols()); ++point)
    for (int axis = 0; axis < dimension; ++axis)
      if (width_of(path, {point, axis}) > 0) moving.push_back({point, axis});
  return moving;
}

std::size_t widest_coordinate(const StoredPath& path, const std::vector<PathCoordinate>& coordinates) {
  const auto widest = std::max_element(coordinates.begin(), coordinates.end(),
                                       [&](const PathCoordinate& a, const PathCoordinate& b) {
                                         return width_of(path, a) < width_of(path, b);
                                       });
  return static_cast<std::size_t>(widest - coordinates.begin());
}

std::string name_of(const PathCoordinate& coordinate, const ProblemStatement& problem) {
  return fmt::format("{} of {}", std::string_view("xyz")[static_cast<std::size_t>(coordinate.axis)],
                     problem.points[static_cast<std::size_t>(coordinate.point)]);
}

const PlanTrail* shown_trail(const ShownScene& record) {
  const auto found = std::find_if(record.trails.begin(), record.trails.end(),
                                  [](const PlanTrail& trail) { return !trail.places.empty(); });
  return found == record.trails.end() ? nullptr : &*found;
}

PathPosition position_at(const StoredPath& path, double length) {
  const auto after =
      std::upper_bound(path.corners.begin(), path.corners.end(), length,
                       [](double value, const PathCorner& corner) { return value < corner.length; });
  if (after == path.corners.begin()) return {};
  const auto corner = static_cast<std::size_t>(after - path.corners.begin()) - 1;
  if (after == path.corners.end()) return {corner, 0};
  const double begin = path.corners[corner].length;
  return {corner, (length - begin) / (after->length - begin)};
}

Figure figure_at(const StoredPath& path, const PathPosition& position) {
  Figure figure = path.corners[position.corner].figure;
  if (position.part > 0)
    figure.points += position.part * (path.corners[position.corner + 1].figure.points - figure.points);
  return figure;
}

Drawing draw_path(const StoredScene& scene) {
  const Instance& instance = scene.record.instance;
  const StoredPath& path = *scene.path;
  const auto moving = moving_coordinates(path, instance.problem.dimension);
  const PathCoordinate coordinate = moving[widest_coordinate(path, moving)];
  const auto place = [&](const PathCorner& corner) {
    return PlotPoint{value_of(corner, coordinate), corner.t};
  };

  PlotSeries curve{"S", PlotMark::curve, {}}, crossings{"t = 1: solutions", PlotMark::circle, {}};
  for (const PathCorner& corner : path.corners) curve.points.push_back(place(corner));
  for (const PathCrossingCorner& crossing : path.crossings)
    crossings.points.push_back(place(path.corners[crossing.corner]));
  constexpr int green_triangle = 2, black_triangle = 6;
  PlotSeries sketch{"sketch", PlotMark::symbol, {place(path.corners.front())}, black_triangle};
  Plot plot;
  plot.description = fmt::format("The path S of {}: t over the coordinate {}", instance.id,
                                 name_of(coordinate, instance.problem));
  const auto [low, high] = range_of(path, coordinate);
  const auto [least, most] = std::minmax_element(path.corners.begin(), path.corners.end(),
                                                 [](const auto& a, const auto& b) { return a.t < b.t; });
  plot.x = axis_over(name_of(coordinate, instance.problem) + " (unit of the lengths)", low, high);
  plot.y = axis_over("t", std::min(0.0, least->t), std::max(1.0, most->t));
  plot.series = {{"", PlotMark::line, {{plot.x.low, 1}, {plot.x.high, 1}}}, std::move(curve)};
  const PlanTrail* trail = shown_trail(scene.record);
  const std::size_t changed = trail == nullptr ? 0 : trail->places.size() - 1;
  if (changed > most_marked_changes)
    plot.description +=
        fmt::format("; {} changes the plan {} times, which is not marked", trail->label, changed);
  if (changed > 0 && changed <= most_marked_changes) {
    PlotSeries changes{trail->label + ": plan changed", PlotMark::symbol, {}, green_triangle};
    for (std::size_t i = 1; i < trail->places.size(); ++i) {
      const PlanPlace& use = trail->places[i];
      const Figure figure = figure_at(path, position_at(path, use.length));
      changes.points.push_back({figure.points(coordinate.axis, coordinate.point), use.t});
    }
    plot.series.push_back(std::move(changes));
  }
  plot.series.push_back(std::move(sketch));
  plot.series.push_back(std::move(crossings));
  return {"path-" + instance.id, to_svg(plot), plot.description};
}

}  // namespace gcs
