#include "harness/results/path_io.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/base/document_text.hpp"
#include "harness/results/file_formats.hpp"
#include "solvers/proven_paths/certified_tracker.hpp"
#include "solvers/reading/json_build.hpp"
#include "solvers/tracking/general_path.hpp"

namespace gcs {
namespace {

constexpr std::string_view convention =
    "each row is a corner of a polyline along S, the last one the first again; the part of S from a row to "
    "the next is within the row's radius of the segment between them; lengths and radii are those of "
    "(coordinates, unit t) in the 2-norm, in the unit of the instance; within: the radius asked for, "
    "relative "
    "to the scene's size";

/// The part of the wanted radius that rounding the corners may take.
constexpr double rounding_part = 1.0 / 8;

/// Radii are rounded up to this part of the wanted one.
constexpr double radius_step = 1e-2;

/// The multiples of a power of ten.
class DecimalGrid {
 public:
  /// The coarsest grid whose step is at most `step` > 0. Powers of ten beyond 10^308 are no doubles.
  explicit DecimalGrid(double step)
      : exponent_(std::max(-308, static_cast<int>(std::floor(std::log10(step))))),
        power_(std::pow(10.0, std::abs(exponent_))) {}

  double step() const { return value(1); }
  double nearest(double x) const { return value(std::round(steps(x))); }
  /// At least x, for x ≥ 0.
  double above(double x) const { return value(std::ceil(steps(x) * round_up)); }

 private:
  // A quotient of whole numbers is rounded once: the double nearest to the decimal.
  double steps(double x) const { return exponent_ < 0 ? x * power_ : x / power_; }
  double value(double steps) const { return exponent_ < 0 ? steps / power_ : steps * power_; }

  int exponent_;
  double power_;
};

/// The decimals of the file's unit to which corners (X, t) are rounded.
class CornerGrid {
 public:
  /// `radius`: the wanted one, in the scene's unit.
  CornerGrid(double radius, Eigen::Index coordinates, int unit_exponent)
      : unit_exponent_(unit_exponent),
        diagonal_(std::sqrt(static_cast<double>(coordinates))),
        places_(std::ldexp(2 * rounding_part * radius / diagonal_, unit_exponent)),
        times_(2 * rounding_part * radius / diagonal_) {}

  Eigen::VectorXd nearest(const Eigen::VectorXd& point) const {
    Eigen::VectorXd result(point.size());
    const Eigen::Index time = point.size() - 1;
    for (Eigen::Index i = 0; i < time; ++i)
      result[i] = std::ldexp(places_.nearest(std::ldexp(point[i], unit_exponent_)), -unit_exponent_);
    result[time] = times_.nearest(point[time]);
    return result;
  }
  /// About how far a corner may move at most.
  double reach() const {
    return std::max(std::ldexp(places_.step(), -unit_exponent_), times_.step()) * diagonal_ / 2;
  }

 private:
  int unit_exponent_;
  double diagonal_;
  DecimalGrid places_, times_;
};

/// The radii grow by what the ends of their segments move, and by what a reader's decimals may be off.
void round_corners(std::vector<PathNode>& nodes, const CornerGrid& grid) {
  double before = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Eigen::VectorXd point = grid.nearest(nodes[i].point);
    const double moved =
        (point - nodes[i].point).norm() + std::numeric_limits<double>::epsilon() * point.norm();
    nodes[i].point = point;
    if (i > 0) nodes[i - 1].radius = (nodes[i - 1].radius + std::max(before, moved)) * round_up;
    before = moved;
  }
}

struct Coordinates {
  std::vector<std::string> moving;  ///< in the order of X
  JsonMembers fixed;
};

Coordinates name_coordinates(const Scene& scene) {
  const DistanceSystem system(scene);
  Coordinates coordinates{std::vector<std::string>(static_cast<std::size_t>(system.unknowns())), {}};
  for (int point = 0; point < scene.point_count(); ++point)
    for (int axis = 0; axis < scene.dimension(); ++axis) {
      const std::string name = fmt::format("{}.{}", scene.problem().points[static_cast<std::size_t>(point)],
                                           std::string_view("xyz")[static_cast<std::size_t>(axis)]);
      const int unknown = system.unknown(point, axis);
      if (unknown >= 0)
        coordinates.moving[static_cast<std::size_t>(unknown)] = name;
      else
        coordinates.fixed.emplace_back(
            name, json_number(std::ldexp(system.given_coordinate(point, axis), scene.unit_exponent())));
    }
  return coordinates;
}

JsonValue row_value(const PathNode& node, int unit_exponent, const DecimalGrid& lengths,
                    const DecimalGrid& radii) {
  const auto in_file_unit = [&](double x) { return std::ldexp(x, unit_exponent); };
  const Eigen::Index time = node.point.size() - 1;
  std::vector<double> row{node.point[time], lengths.nearest(in_file_unit(node.length)),
                          radii.above(in_file_unit(node.radius))};
  for (Eigen::Index i = 0; i < time; ++i) row.push_back(in_file_unit(node.point[i]));
  return json_array_of(row, json_number);
}

JsonValue crossings_value(const std::vector<PathNode>& nodes) {
  std::vector<JsonValue> crossings;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (nodes[i].crossing != 0)
      crossings.push_back(json_object(
          {{"row", json_number(static_cast<double>(i))}, {"direction", json_number(nodes[i].crossing)}}));
  return json_array(std::move(crossings));
}

}  // namespace

std::optional<std::string> why_no_path_text(const Scene& scene) {
  if (is_path_of_elements(scene))
    return "paths are written of points with distances between them only; full-space with mode=certified "
           "proves S";
  return why_not_proven(scene);
}

std::string path_text(const Instance& instance, const Scene& scene, const std::vector<ProvenArc>& arcs,
                      double within) {
  const int unit_exponent = scene.unit_exponent();
  const double radius = within * scene.size(), in_file_unit = std::ldexp(radius, unit_exponent);
  const CornerGrid corners(radius, arcs.front().curve.coefficients().rows(), unit_exponent);
  std::vector<PathNode> nodes = polyline(arcs, (1 - radius_step) * radius - corners.reach());
  round_corners(nodes, corners);
  const DecimalGrid lengths(in_file_unit), radii(in_file_unit * radius_step);
  Coordinates coordinates = name_coordinates(scene);
  std::vector<std::string> columns{"t", "length", "radius"};
  columns.insert(columns.end(), coordinates.moving.begin(), coordinates.moving.end());
  const double length = lengths.nearest(std::ldexp(nodes.back().length, unit_exponent));
  return document_text(path_format, [&](DocumentWriter& document) {
    document.member("instance", instance.document);
    document.member("convention", json_text(std::string(convention)));
    document.member("unit", json_number(std::ldexp(1.0, unit_exponent)));
    document.member("within", json_number(within));
    document.member("proven", json_boolean(true));
    document.member("closed", json_boolean(true));
    document.member("tubes", json_number(static_cast<double>(arcs.size())));
    document.member("length", json_number(length));
    document.member("crossings", crossings_value(nodes));
    document.member("fixed", json_object(std::move(coordinates.fixed)));
    document.member("columns", json_texts(columns));
    document.list("rows", nodes,
                  [&](const PathNode& node) { return row_value(node, unit_exponent, lengths, radii); });
  });
}

}  // namespace gcs
