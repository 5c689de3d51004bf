#include "solvers/reading/instance_positions.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>

#include "solvers/numeric/svd.hpp"
#include "solvers/reading/instance_names.hpp"

namespace gcs {
namespace {

/// Sines and ratios below this come from rounding:
/// coordinates have 16 digits, and differences lose one or two.
constexpr double rounding = 1e-14;

struct Positions {
  std::vector<std::optional<Eigen::Vector3d>> points;
  std::vector<std::optional<LinePosition>> lines;

  bool has(int entity) const {
    const auto points_count = static_cast<int>(points.size());
    return entity < points_count ? points[entity].has_value() : lines[entity - points_count].has_value();
  }
};

Positions read_positions(const JsonCursor& cursor, const ProblemStatement& problem) {
  Positions positions;
  positions.points.resize(problem.points.size());
  positions.lines.resize(problem.lines.size());
  for (const auto& [name, position] : cursor.members()) {
    const int entity = entity_number(problem, name, position);
    if (problem.is_point(entity)) {
      positions.points[entity] = position.coordinates(problem.dimension);
    } else {
      positions.lines[entity - problem.points.size()] = position.line_position();
    }
  }
  return positions;
}

std::vector<std::array<std::string, 3>> point_texts(const JsonCursor& cursor,
                                                    const ProblemStatement& problem) {
  std::vector<std::array<std::string, 3>> texts(problem.points.size());
  for (const auto& [name, position] : cursor.members()) {
    const int entity = entity_number(problem, name, position);
    if (problem.is_point(entity)) texts[entity] = position.coordinate_texts(problem.dimension);
  }
  return texts;
}

int entity_count(const ProblemStatement& problem) {
  return static_cast<int>(problem.points.size() + problem.lines.size());
}

/// True when a and b are parallel or one of them is zero.
bool parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.stableNormalized().cross(b.stableNormalized()).norm() <= rounding;
}

bool coincide(const Eigen::Vector3d& point, const LinePosition& line) {
  return parallel(point - line.point, line.direction);
}

/// Coordinates relative to the first position and divided by the largest, so that no product overflows.
class Normalisation {
 public:
  explicit Normalisation(const std::vector<Eigen::Vector3d>& positions)
      : half_origin_(positions.front() / 2) {
    double extent = 0;
    for (const Eigen::Vector3d& position : positions)
      extent = std::max(extent, (position / 2 - half_origin_).cwiseAbs().maxCoeff());
    if (extent > 0) half_scale_ = extent;
  }

  Eigen::Vector3d operator()(const Eigen::Vector3d& position) const {
    return (position / 2 - half_origin_) / half_scale_;
  }

 private:
  Eigen::Vector3d half_origin_;
  double half_scale_ = 1;
};

std::vector<Eigen::Vector3d> all_positions(const Positions& fixed) {
  std::vector<Eigen::Vector3d> positions;
  for (const auto& point : fixed.points)
    if (point) positions.push_back(*point);
  for (const auto& line : fixed.lines)
    if (line) positions.push_back(line->point);
  return positions;
}

/// Linear conditions on a rigid motion (translation, rotation): it leaves the entity where it is. The plane's
/// three motions are the translations along x and y and the rotation about z.
Eigen::Matrix<double, Eigen::Dynamic, 6> stillness_conditions(const Eigen::Vector3d& point) {
  Eigen::Matrix<double, 3, 6> conditions;
  conditions << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  for (int axis = 0; axis < 3; ++axis) conditions.col(3 + axis) = Eigen::Vector3d::Unit(axis).cross(point);
  return conditions;
}

Eigen::Matrix<double, Eigen::Dynamic, 6> stillness_conditions(const LinePosition& line) {
  const Eigen::Vector3d across = line.direction.unitOrthogonal();
  Eigen::Matrix<double, 2, 3> normals;
  normals << across.transpose(), line.direction.cross(across).transpose();
  Eigen::Matrix<double, 4, 6> conditions = Eigen::Matrix<double, 4, 6>::Zero();
  conditions.topRows<2>() = normals * stillness_conditions(line.point);
  for (int axis = 0; axis < 3; ++axis) {
    conditions.block<2, 1>(2, 3 + axis) = normals * Eigen::Vector3d::Unit(axis).cross(line.direction);
  }
  return conditions;
}

/// True when no rigid motion of the plane or of space keeps all fixed entities where they are.
bool hold_still(const Positions& fixed, int dimension) {
  const Normalisation normalise(all_positions(fixed));
  Eigen::Matrix<double, Eigen::Dynamic, 6> conditions(0, 6);
  const auto append = [&](const Eigen::Matrix<double, Eigen::Dynamic, 6>& more) {
    conditions.conservativeResize(conditions.rows() + more.rows(), 6);
    conditions.bottomRows(more.rows()) = more;
  };
  for (const auto& point : fixed.points) {
    if (point) append(stillness_conditions(normalise(*point)));
  }
  for (const auto& line : fixed.lines) {
    if (line) append(stillness_conditions(LinePosition{normalise(line->point), line->direction}));
  }
  Eigen::MatrixXd wanted = conditions;
  if (dimension == 2) wanted = conditions(Eigen::all, std::vector<int>{0, 1, 5}).eval();
  Eigen::JacobiSVD<Eigen::MatrixXd> decomposition(wanted);
  decomposition.setThreshold(rounding);
  return decomposition.rank() == wanted.cols();
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

void refuse_coincident_fixed_points(const JsonCursor& fixed, const ProblemStatement& problem) {
  for (std::size_t a = 0; a < problem.points.size(); ++a) {
    for (std::size_t b = a + 1; b < problem.points.size(); ++b) {
      if (!problem.fixed_points[a] || problem.fixed_points[a] != problem.fixed_points[b]) continue;
      fixed.fail("'" + problem.points[a] + "' and '" + problem.points[b] + "' are fixed at the same place",
                 "give different places, or use one point");
    }
  }
}

/// A line that is sought by its distances from given points (4p1L). Wherever these are they make a question,
/// to which infinitely many lines or none may be the answer.
bool seeks_line_from_given_points(const Positions& fixed) {
  const auto is_given = [](const auto& position) { return position.has_value(); };
  return fixed.lines.size() == 1 && !fixed.lines[0] && fixed.points.size() == 4 &&
         std::all_of(fixed.points.begin(), fixed.points.end(), is_given);
}

void refuse_missing(const JsonCursor& sketch, const ProblemStatement& problem, const Positions& positions) {
  std::vector<int> missing;
  for (int entity = 0; entity < entity_count(problem); ++entity) {
    if (!positions.has(entity)) missing.push_back(entity);
  }
  if (missing.empty()) return;
  sketch.fail("the sketch has no position for " + entity_names(problem, missing),
              "give a position for every point and line, or leave the sketch out");
}

bool same_position(const LinePosition& a, const LinePosition& b) {
  return a.point == b.point && a.direction == b.direction;
}

void refuse_moved_fixed(const JsonCursor& sketch, const ProblemStatement& problem, const Figure& figure) {
  for (int entity = 0; entity < entity_count(problem); ++entity) {
    if (!problem.is_fixed(entity)) continue;
    const auto line = entity - static_cast<int>(problem.points.size());
    const bool same = problem.is_point(entity)
                          ? figure.points.col(entity) == *problem.fixed_points[entity]
                          : same_position(figure.lines[line], *problem.fixed_lines[line]);
    if (same) continue;
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
  const Positions positions = read_positions(fixed, problem);
  problem.fixed_points = positions.points;
  problem.fixed_lines = positions.lines;
  problem.fixed_point_texts = point_texts(fixed, problem);
  if (fixed.members().empty() || seeks_line_from_given_points(positions)) return;
  refuse_coincident_fixed_points(fixed, problem);
  if (!hold_still(positions, problem.dimension)) {
    fixed.fail("the fixed positions leave the figure movable as a whole",
               problem.dimension == 2 ? "fix two or more points, or none"
                                      : "fix three or more points that are not all on one line, or none");
  }
}

void check_fixed(const JsonCursor& fixed, const ProblemStatement& problem) {
  refuse_mixed_neighbours(fixed, problem);
  refuse_far_origin(fixed, problem);
}

void read_sketch(const JsonCursor& sketch, ProblemStatement& problem) {
  const Positions positions = read_positions(sketch, problem);
  refuse_missing(sketch, problem, positions);
  Figure figure;
  figure.points.resize(3, static_cast<Eigen::Index>(problem.points.size()));
  for (std::size_t i = 0; i < problem.points.size(); ++i) figure.points.col(i) = *positions.points[i];
  for (const auto& line : positions.lines) figure.lines.push_back(*line);
  refuse_moved_fixed(sketch, problem, figure);
  refuse_coincident_ends(sketch, problem, figure);
  if (is_flat(problem, figure)) {
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
