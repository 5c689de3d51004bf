#include "harness/report/page_data.hpp"

#include <fmt/format.h>

#include "harness/drawings/path_drawing.hpp"
#include "solvers/reading/json_build.hpp"

namespace gcs {
namespace {

JsonValue vector_value(const Eigen::Vector3d& v) {
  return json_array({json_number(v.x()), json_number(v.y()), json_number(v.z())});
}

JsonValue points_value(const Figure& figure) {
  std::vector<JsonValue> points;
  for (Eigen::Index i = 0; i < figure.points.cols(); ++i)
    points.push_back(vector_value(figure.points.col(i)));
  return json_array(std::move(points));
}

JsonValue lines_value(const Figure& figure) {
  std::vector<JsonValue> lines;
  for (const LinePosition& line : figure.lines)
    lines.push_back(
        json_object({{"point", vector_value(line.point)}, {"direction", vector_value(line.direction)}}));
  return json_array(std::move(lines));
}

JsonValue edges_value(const ProblemStatement& problem) {
  std::vector<JsonValue> edges;
  for (const DistanceConstraint& c : problem.constraints) {
    const auto [a, b] = std::minmax(c.between[0], c.between[1]);
    edges.push_back(json_object({{"a", json_number(a)},
                                 {"b", json_number(b)},
                                 {"label", json_text(c.id)},
                                 {"length", json_text((c.is_squared ? "√" : "") + c.given.text)}}));
  }
  return json_array(std::move(edges));
}

JsonValue solutions_value(const std::vector<ShownSolution>& solutions) {
  std::vector<JsonValue> values;
  for (const ShownSolution& solution : solutions)
    values.push_back(json_object({{"multiplicity", json_number(solution.multiplicity)},
                                  {"points", points_value(solution.figure)},
                                  {"lines", lines_value(solution.figure)}}));
  return json_array(std::move(values));
}

JsonValue trails_value(const std::vector<PlanTrail>& trails) {
  std::vector<JsonValue> values;
  for (const PlanTrail& trail : trails) {
    std::vector<JsonValue> places;
    for (const PlanPlace& place : trail.places)
      places.push_back(json_object({{"t", json_number(place.t)},
                                    {"s", json_number(place.length)},
                                    {"removed", json_texts(place.removed)}}));
    values.push_back(json_object({{"label", json_text(trail.label)},
                                  {"cause", json_text(trail.cause)},
                                  {"places", json_array(std::move(places))}}));
  }
  return json_array(std::move(values));
}

JsonValue stops_value(const StoredScene& scene) {
  std::vector<JsonValue> stops;
  for (std::size_t i = 0; i < scene.path->crossings.size(); ++i) {
    const PathCrossingCorner& crossing = scene.path->crossings[i];
    const auto& met = scene.record.crossings[i];
    std::vector<JsonValue> signs;
    for (const int sign : met ? met->signs : AxisSigns{1, 1, 1}) signs.push_back(json_number(sign));
    stops.push_back(json_object(
        {{"row", json_number(static_cast<double>(crossing.corner))},
         {"direction", json_number(crossing.direction)},
         {"solution", json_or_null(met, [](const MetSolution& m) { return json_number(m.solution); })},
         {"signs", json_array(std::move(signs))}}));
  }
  return json_array(std::move(stops));
}

JsonValue rows_value(const StoredPath& path, const std::vector<PathCoordinate>& moving) {
  std::vector<JsonValue> rows;
  for (const PathCorner& corner : path.corners) {
    std::vector<JsonValue> row{json_number(corner.t), json_number(corner.length)};
    for (const PathCoordinate& c : moving) row.push_back(json_number(corner.figure.points(c.axis, c.point)));
    rows.push_back(json_array(std::move(row)));
  }
  return json_array(std::move(rows));
}

JsonValue path_value(const StoredScene& scene) {
  if (!scene.path) return json_null();
  const auto moving = moving_coordinates(*scene.path, scene.record.instance.problem.dimension);
  std::vector<JsonValue> names;
  for (const PathCoordinate& c : moving)
    names.push_back(json_array({json_number(c.point), json_number(c.axis)}));
  return json_object({{"length", json_number(scene.path->length)},
                      {"moving", json_array(std::move(names))},
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
                      {"edges", edges_value(instance.problem)},
                      {"solutions", solutions_value(scene.record.solutions)},
                      {"trails", trails_value(scene.record.trails)},
                      {"coordinate", json_number(static_cast<double>(first_coordinate(scene)))},
                      {"path", path_value(scene)}});
}

}  // namespace

std::string page_data(const std::vector<const StoredScene*>& scenes) {
  std::vector<JsonValue> values;
  for (const StoredScene* scene : scenes) values.push_back(scene_value(*scene));
  return to_text(json_object({{"scenes", json_array(std::move(values))}}), -1);
}

}  // namespace gcs
