#include "harness/report/page_data.hpp"

#include <fmt/format.h>

#include "harness/drawings/path_drawing.hpp"
#include "solvers/reading/figure_json.hpp"

namespace gcs {
namespace {

/// With three coordinates each, also in the plane.
JsonValue points_value(const Figure& figure) {
  return json_array_of(figure.points.colwise(),
                       [](const Eigen::Vector3d& point) { return json_coordinates(point, 3); });
}

JsonValue lines_value(const Figure& figure) {
  return json_array_of(figure.lines, [](const LinePosition& line) { return json_line_position(line, 3); });
}

JsonValue edge_value(const DistanceConstraint& c) {
  const auto [a, b] = std::minmax(c.between[0], c.between[1]);
  return json_object({{"a", json_number(a)},
                      {"b", json_number(b)},
                      {"label", json_text(c.id)},
                      {"length", json_text((c.is_squared ? "√" : "") + c.given.text)}});
}

JsonValue solution_value(const ShownSolution& solution) {
  return json_object({{"multiplicity", json_number(solution.multiplicity)},
                      {"points", points_value(solution.figure)},
                      {"lines", lines_value(solution.figure)}});
}

JsonValue place_value(const PlanPlace& place) {
  return json_object({{"t", json_number(place.t)},
                      {"s", json_number(place.length)},
                      {"removed", json_texts(place.removed)}});
}

JsonValue trail_value(const PlanTrail& trail) {
  return json_object({{"label", json_text(trail.label)},
                      {"cause", json_text(trail.cause)},
                      {"places", json_array_of(trail.places, place_value)}});
}

JsonValue stops_value(const StoredScene& scene) {
  std::vector<JsonValue> stops;
  for (std::size_t i = 0; i < scene.path->crossings.size(); ++i) {
    const PathCrossingCorner& crossing = scene.path->crossings[i];
    const auto& met = scene.record.crossings[i];
    stops.push_back(json_object(
        {{"row", json_number(static_cast<double>(crossing.corner))},
         {"direction", json_number(crossing.direction)},
         {"solution", json_or_null(met, [](const MetSolution& m) { return json_number(m.solution); })},
         {"signs", json_array_of(met ? met->signs : AxisSigns{1, 1, 1}, json_number)}}));
  }
  return json_array(std::move(stops));
}

JsonValue rows_value(const StoredPath& path, const std::vector<PathCoordinate>& moving) {
  return json_array_of(path.corners, [&](const PathCorner& corner) {
    std::vector<JsonValue> row{json_number(corner.t), json_number(corner.length)};
    for (const PathCoordinate& c : moving) row.push_back(json_number(corner.figure.points(c.axis, c.point)));
    return json_array(std::move(row));
  });
}

JsonValue path_value(const StoredScene& scene) {
  if (!scene.path) return json_null();
  const auto moving = moving_coordinates(*scene.path, scene.record.instance.problem.dimension);
  const auto coordinate = [](const PathCoordinate& c) {
    return json_array({json_number(c.point), json_number(c.axis)});
  };
  return json_object({{"length", json_number(scene.path->length)},
                      {"moving", json_array_of(moving, coordinate)},
                      {"fixed", points_value(scene.path->corners.front().figure)},
                      {"stops", stops_value(scene)},
                      {"rows", rows_value(*scene.path, moving)}});
}

std::size_t first_coordinate(const StoredScene& scene) {
  if (!scene.path) return 0;
  const auto moving = moving_coordinates(*scene.path, scene.record.instance.problem.dimension);
  return 1 + widest_coordinate(*scene.path, moving);
}

JsonValue scene_value(const StoredScene& scene) {
  const Instance& instance = scene.record.instance;
  return json_object({{"id", json_text(instance.id)},
                      {"dimension", json_number(instance.problem.dimension)},
                      {"points", json_texts(instance.problem.points)},
                      {"lines", json_texts(instance.problem.lines)},
                      {"edges", json_array_of(instance.problem.constraints, edge_value)},
                      {"solutions", json_array_of(scene.record.solutions, solution_value)},
                      {"trails", json_array_of(scene.record.trails, trail_value)},
                      {"coordinate", json_number(static_cast<double>(first_coordinate(scene)))},
                      {"path", path_value(scene)}});
}

}  // namespace

std::string page_data(const std::vector<const StoredScene*>& scenes) {
  const auto value = [](const StoredScene* scene) { return scene_value(*scene); };
  return to_text(json_object({{"scenes", json_array_of(scenes, value)}}), -1);
}

}  // namespace gcs
