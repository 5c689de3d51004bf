#include "solvers/reading/instance_positions.hpp"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>

#include "solvers/elements/given_elements.hpp"
#include "solvers/reading/element_position.hpp"
#include "solvers/reading/instance_names.hpp"
#include "solvers/reading/sketch_pose.hpp"

namespace gcs {
namespace {

/// Sines and ratios below this come from rounding:
/// coordinates have 16 digits, and differences lose one or two.
constexpr double rounding = 1e-14;

struct Positions {
  std::vector<std::optional<Eigen::Vector3d>> points;
  std::vector<std::optional<LinePosition>> lines;
  std::vector<std::optional<PlanePosition>> planes;
};

Positions read_positions(const JsonCursor& cursor, const ProblemStatement& problem) {
  Positions positions;
  positions.points.resize(problem.points.size());
  positions.lines.resize(problem.lines.size());
  positions.planes.resize(problem.planes.size());
  for (const auto& [name, position] : cursor.members()) {
    const int entity = entity_number(problem, name, position);
    if (problem.is_point(entity)) {
      positions.points[entity] = position.coordinates(problem.dimension);
    } else if (problem.is_line(entity)) {
      positions.lines[problem.line_of(entity)] = position.line_position(problem.dimension);
    } else {
      positions.planes[problem.plane_of(entity)] = position.plane_position();
    }
  }
  return positions;
}

/// See ProblemStatement::fixed_texts.
std::vector<std::array<std::string, 3>> position_texts(const JsonCursor& cursor,
                                                       const ProblemStatement& problem) {
  std::vector<std::array<std::string, 3>> texts(problem.points.size() + 2 * problem.lines.size() +
                                                2 * problem.planes.size());
  for (const auto& [name, position] : cursor.members()) {
    const int entity = entity_number(problem, name, position);
    const std::size_t row = fixed_text_row(problem, entity);
    const auto texts_of = [&place = position](const char* member, int count) {
      return place.required(member).coordinate_texts(count);
    };
    if (problem.is_point(entity)) {
      texts[row] = position.coordinate_texts(problem.dimension);
    } else if (problem.is_line(entity)) {
      texts[row] = texts_of("point", problem.dimension);
      texts[row + 1] = texts_of("direction", problem.dimension);
    } else {
      texts[row] = texts_of("normal", 3);
      texts[row + 1][0] = position.required("offset").number().text;
    }
  }
  return texts;
}

/// True when a and b are parallel or one of them is zero.
bool parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.stableNormalized().cross(b.stableNormalized()).norm() <= rounding;
}

bool coincide(const Eigen::Vector3d& point, const LinePosition& line) {
  return parallel(point - line.point, line.direction);
}

/// Of a line: it is placed against fixed points or against free ones.
void refuse_mixed_neighbours(const JsonCursor& fixed, const ProblemStatement& problem) {
  for (std::size_t line = 0; line < problem.lines.size(); ++line) {
    const int entity = static_cast<int>(problem.points.size() + line);
    std::vector<int> held;
    std::vector<int> free;
    for (const DistanceConstraint& constraint : problem.constraints) {
      const auto [point, other] = std::minmax(constraint.between[0], constraint.between[1]);
      if (other == entity) (problem.is_fixed(point) ? held : free).push_back(point);
    }
    if (problem.is_fixed(entity) || held.empty() || free.empty()) continue;
    fixed.fail("the line '" + problem.lines[line] + "' is placed against fixed points (" +
                   entity_names(problem, held) + ") and free ones (" + entity_names(problem, free) + ")",
               "fix all points that the line is placed against, or none");
  }
}

/// Doubles hold distances as finely as they hold the coordinates that these are between.
void refuse_far_origin(const JsonCursor& fixed, const ProblemStatement& problem) {
  constexpr double too_far = 0x1p20;
  double reach = 0, extent = 0;
  std::vector<Eigen::Vector3d> positions;
  for (const DistanceConstraint& constraint : problem.constraints) {
    reach = std::max(reach, constraint.length());
    for (const int end : constraint.between)
      if (problem.is_point(end) && problem.is_fixed(end)) positions.push_back(*problem.fixed_points[end]);
  }
  for (const Eigen::Vector3d& position : positions) {
    extent = std::max(extent, position.cwiseAbs().maxCoeff());
    reach = std::max(reach, (position - positions.front()).cwiseAbs().maxCoeff());
  }
  if (extent / too_far <= reach) return;
  fixed.fail(
      "the fixed points are a million times further from the origin than from each other and from the rest",
      "put the origin near them: there doubles hold the distances");
}

std::vector<ElementPosition> fixed_elements(const ProblemStatement& problem) {
  std::vector<ElementPosition> elements;
  for (const auto& point : problem.fixed_points)
    if (point) elements.emplace_back(*point);
  for (const auto& line : problem.fixed_lines)
    if (line) elements.emplace_back(*line);
  return elements;
}

bool has_position(const Positions& positions, const ProblemStatement& problem, int entity) {
  if (problem.is_point(entity)) return positions.points[entity].has_value();
  return problem.is_line(entity) ? positions.lines[problem.line_of(entity)].has_value()
                                 : positions.planes[problem.plane_of(entity)].has_value();
}

template <typename Position>
void fill(std::optional<Position>& position, const std::optional<Position>& given) {
  if (!position) position = given;
}

void add_fixed(const ProblemStatement& problem, Positions& positions) {
  for (std::size_t i = 0; i < positions.points.size(); ++i)
    fill(positions.points[i], problem.fixed_points[i]);
  for (std::size_t i = 0; i < positions.lines.size(); ++i) fill(positions.lines[i], problem.fixed_lines[i]);
  for (std::size_t i = 0; i < positions.planes.size(); ++i)
    fill(positions.planes[i], problem.fixed_planes[i]);
}

void add(const ProblemStatement& problem, int entity, const ElementPosition& position, Positions& positions) {
  if (problem.is_point(entity)) {
    fill(positions.points[entity], std::optional(std::get<Eigen::Vector3d>(position)));
  } else if (problem.is_line(entity)) {
    fill(positions.lines[problem.line_of(entity)], std::optional(std::get<LinePosition>(position)));
  } else {
    fill(positions.planes[problem.plane_of(entity)], std::optional(std::get<PlanePosition>(position)));
  }
}

/// What a body has that is not there already.
void add_bodies(const ProblemStatement& problem, Positions& positions) {
  for (const RigidBody& body : problem.bodies) {
    const auto pose = sketched_pose(problem, body, positions.points);
    if (!pose) continue;
    for (std::size_t i = 0; i < body.elements.size(); ++i)
      add(problem, body.elements[i].entity, (*pose)[i], positions);
  }
}

void refuse_missing(const JsonCursor& sketch, const ProblemStatement& problem, const Positions& positions) {
  std::vector<int> missing;
  for (int entity = 0; entity < problem.entity_count(); ++entity) {
    if (!has_position(positions, problem, entity)) missing.push_back(entity);
  }
  if (missing.empty()) return;
  sketch.fail("the sketch has no position for " + entity_names(problem, missing),
              std::string("give a position for every point") +
                  (problem.planes.empty() ? " and line" : ", line and plane") + ", or leave the sketch out");
}

bool same_position(const LinePosition& a, const LinePosition& b) {
  return a.point == b.point && a.direction == b.direction;
}

bool same_position(const PlanePosition& a, const PlanePosition& b) {
  return a.normal == b.normal && a.offset == b.offset;
}

bool is_where_fixed(const ProblemStatement& problem, const Figure& figure, int entity) {
  if (problem.is_point(entity)) return figure.points.col(entity) == *problem.fixed_points[entity];
  const int line = problem.line_of(entity), plane = problem.plane_of(entity);
  return problem.is_line(entity) ? same_position(figure.lines[line], *problem.fixed_lines[line])
                                 : same_position(figure.planes[plane], *problem.fixed_planes[plane]);
}

void refuse_moved_fixed(const JsonCursor& sketch, const ProblemStatement& problem, const Figure& figure) {
  for (int entity = 0; entity < problem.entity_count(); ++entity) {
    if (!problem.is_fixed(entity) || is_where_fixed(problem, figure, entity)) continue;
    sketch.required(problem.name(entity))
        .fail("'" + problem.name(entity) + "' is fixed somewhere else", "repeat the fixed position");
  }
}

void refuse_coincident_ends(const JsonCursor& sketch, const ProblemStatement& problem, const Figure& figure) {
  for (const DistanceConstraint& constraint : problem.constraints) {
    const auto [a, b] = std::minmax(constraint.between[0], constraint.between[1]);
    // A difference of doubles is zero only when they are equal: tiny distances are allowed.
    const bool together = problem.is_point(b)
                              ? figure.points.col(a) == figure.points.col(b)
                              : constraint.given.value > 0 &&
                                    coincide(figure.points.col(a), figure.lines[b - problem.points.size()]);
    if (!together) continue;
    sketch.fail("the ends '" + problem.name(a) + "' and '" + problem.name(b) + "' of '" + constraint.id +
                    "' are at the same place in the sketch",
                "move one of them");
  }
}

/// In a sketch that is flat (on a line in the plane, in a plane in space) the distances depend on each other
/// to first order, so that no path can start from it.
bool is_flat(const ProblemStatement& problem, const Figure& figure) {
  const auto count = figure.points.cols();
  if (count <= problem.dimension || !problem.lines.empty()) return false;
  const double scale = figure.points.cwiseAbs().maxCoeff();
  if (scale == 0) return true;
  Eigen::MatrixXd centred = (figure.points / scale).topRows(problem.dimension);
  centred.colwise() -= centred.rowwise().mean().eval();
  const Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(centred);
  const Eigen::VectorXd& extents = decomposition.singularValues();
  return extents[problem.dimension - 1] <= rounding * extents[0];
}

}  // namespace

void read_fixed(const JsonCursor& fixed, ProblemStatement& problem) {
  Positions positions = read_positions(fixed, problem);
  problem.fixed_points = std::move(positions.points);
  problem.fixed_lines = std::move(positions.lines);
  problem.fixed_planes = std::move(positions.planes);
  problem.fixed_texts = position_texts(fixed, problem);
}

void refuse_coincident_fixed_points(const JsonCursor& fixed, const ProblemStatement& problem) {
  for (std::size_t a = 0; a < problem.points.size(); ++a) {
    for (std::size_t b = a + 1; b < problem.points.size(); ++b) {
      if (!problem.fixed_points[a] || problem.fixed_points[a] != problem.fixed_points[b]) continue;
      fixed.fail("'" + problem.points[a] + "' and '" + problem.points[b] + "' are fixed at the same place",
                 "give different places, or use one point");
    }
  }
}

bool seeks_line_from_given_points(const ProblemStatement& problem) {
  const auto is_given = [](const auto& position) { return position.has_value(); };
  return problem.lines.size() == 1 && !problem.fixed_lines[0] && problem.points.size() == 4 &&
         std::all_of(problem.fixed_points.begin(), problem.fixed_points.end(), is_given);
}

void require_still(const JsonCursor& fixed, const ProblemStatement& problem) {
  if (fixed.members().empty() || seeks_line_from_given_points(problem)) return;
  refuse_coincident_fixed_points(fixed, problem);
  if (motions_left(fixed_elements(problem), problem.dimension) > 0) {
    fixed.fail("the fixed positions leave the figure movable as a whole",
               problem.dimension == 2 ? "fix two or more points, or none"
                                      : "fix three or more points that are not all on one line, or none");
  }
}

void check_fixed(const JsonCursor& fixed, const ProblemStatement& problem) {
  refuse_mixed_neighbours(fixed, problem);
  refuse_far_origin(fixed, problem);
}

void read_sketch(const JsonCursor& sketch, InstanceFormat format, ProblemStatement& problem) {
  Positions positions = read_positions(sketch, problem);
  if (format == InstanceFormat::general) {
    add_fixed(problem, positions);
    add_bodies(problem, positions);
  }
  refuse_missing(sketch, problem, positions);
  Figure figure;
  figure.points.resize(3, static_cast<Eigen::Index>(problem.points.size()));
  for (std::size_t i = 0; i < problem.points.size(); ++i) figure.points.col(i) = *positions.points[i];
  for (const auto& line : positions.lines) figure.lines.push_back(*line);
  for (const auto& plane : positions.planes) figure.planes.push_back(*plane);
  refuse_moved_fixed(sketch, problem, figure);
  refuse_coincident_ends(sketch, problem, figure);
  if (!problem.is_general() && is_flat(problem, figure)) {
    sketch.fail(problem.dimension == 2 ? "all points of the sketch are on one line"
                                       : "all points of the sketch are in one plane",
                "move a point out of it, or leave the sketch out");
  }
  problem.sketch = std::move(figure);
}

void check_sketch_frame(const JsonCursor& sketch, const Scene& scene) {
  if (scene.is_anchored()) return;
  const ProblemStatement& problem = scene.problem();
  const Figure& figure = *problem.sketch;
  const Reference& reference = scene.reference();
  const std::string remedy = "move one of them, or choose another reference";
  if (reference.line >= 0) {
    if (reference.height >= 0 &&
        coincide(figure.points.col(reference.height), figure.lines[reference.line])) {
      sketch.fail("the reference's height '" + problem.points[reference.height] + "' lies on its line '" +
                      problem.lines[reference.line] + "' in the sketch",
                  remedy);
    }
    return;
  }
  if (reference.axis < 0) return;
  const Eigen::Vector3d origin = figure.points.col(reference.origin);
  const Eigen::Vector3d axis = figure.points.col(reference.axis) - origin;
  if (axis.isZero(0)) {
    sketch.fail("the reference points " + entity_names(problem, {reference.origin, reference.axis}) +
                    " are at the same place in the sketch",
                remedy);
  }
  if (reference.plane >= 0 && parallel(axis, figure.points.col(reference.plane) - origin)) {
    sketch.fail("the reference points " +
                    entity_names(problem, {reference.origin, reference.axis, reference.plane}) +
                    " are on one line in the sketch",
                remedy);
  }
}

}  // namespace gcs
