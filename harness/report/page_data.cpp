#include "harness/report/page_data.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "harness/drawings/graph_drawing.hpp"
#include "harness/drawings/path_drawing.hpp"
#include "solvers/elements/body_motion.hpp"
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

JsonValue planes_value(const Figure& figure) { return json_array_of(figure.planes, json_plane_position); }

JsonValue edge_value(const std::string& label, int a, int b, bool is_squared, const Decimal& given) {
  return json_object({{"a", json_number(std::min(a, b))},
                      {"b", json_number(std::max(a, b))},
                      {"label", json_text(label)},
                      {"length", json_text((is_squared ? "√" : "") + given.text)}});
}

/// All distances.
JsonValue edges_value(const ProblemStatement& problem) {
  std::vector<JsonValue> edges;
  for (const DistanceConstraint& c : problem.constraints)
    edges.push_back(edge_value(c.id, c.between[0], c.between[1], c.is_squared, c.given));
  for (const Relation& relation : problem.relations)
    if (relation.type == "distance")
      edges.push_back(edge_value(relation.id, relation.of[0].entity, relation.of[1].entity,
                                 relation.form == Relation::Form::squared, relation.given));
  return json_array(std::move(edges));
}

JsonValue body_value(const RigidBody& body) {
  return json_object(
      {{"name", json_text(body.name)}, {"elements", json_array_of(entities_of(body), json_number)}});
}

/// Rows of the rotation from the file's position of the body to that in the figure.
JsonValue turn_value(const ProblemStatement& problem, const RigidBody& body, const Figure& figure) {
  std::vector<ElementPosition> from, to;
  for (const BodyElement& element : body.elements) {
    from.push_back(position_in_body(problem, element));
    to.push_back(position_of(problem, element.entity, figure));
  }
  const Eigen::Matrix3d turn = nearest_motion(from, to, problem.dimension).turn;
  return json_array_of(turn.rowwise(), [](const auto& row) { return json_coordinates(row.transpose(), 3); });
}

JsonValue solution_value(const ProblemStatement& problem, const ShownSolution& solution) {
  const auto turn = [&](const RigidBody& body) { return turn_value(problem, body, solution.figure); };
  return json_object({{"multiplicity", json_number(solution.multiplicity)},
                      {"points", points_value(solution.figure)},
                      {"lines", lines_value(solution.figure)},
                      {"planes", planes_value(solution.figure)},
                      {"turns", json_array_of(problem.bodies, turn)}});
}

JsonValue curve_value(const ShownCurve& curve) {
  const auto figure = [](const Figure& one) {
    return json_object(
        {{"points", points_value(one)}, {"lines", lines_value(one)}, {"planes", planes_value(one)}});
  };
  return json_object({{"label", json_text(curve.label)},
                      {"constraint", json_text(curve.constraint)},
                      {"from", json_or_null(curve.from, json_number)},
                      {"to", json_or_null(curve.to, json_number)},
                      {"figures", json_array_of(curve.figures, figure)}});
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
  const ProblemStatement& problem = instance.problem;
  const auto solution = [&](const ShownSolution& shown) { return solution_value(problem, shown); };
  return json_object({{"id", json_text(instance.id)},
                      {"dimension", json_number(problem.dimension)},
                      {"points", json_texts(problem.points)},
                      {"lines", json_texts(problem.lines)},
                      {"planes", json_texts(problem.planes)},
                      {"bodies", json_array_of(problem.bodies, body_value)},
                      {"edges", edges_value(problem)},
                      {"solutions", json_array_of(scene.record.solutions, solution)},
                      {"curves", json_array_of(scene.record.curves, curve_value)},
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
