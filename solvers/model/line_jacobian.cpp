#include "solvers/model/line_jacobian.hpp"

#include <complex>
#include <utility>
#include <vector>

#include "solvers/model/complex_lines.hpp"
#include "solvers/model/complex_points.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// Of each coordinate the column, or −1 where it is fixed.
struct Columns {
  std::vector<int> of_point;  ///< 3·point + axis
  std::vector<int> of_line;   ///< the first of six, by line
  int count = 0;
  int free_lines = 0;
};

bool is_fixed(const Scene& scene, int point, int axis) {
  if (scene.problem().is_fixed(point)) return true;
  return !scene.is_anchored() && point == scene.reference().height && axis < 2;
}

Columns columns_of(const Scene& scene) {
  Columns columns;
  for (int point = 0; point < scene.point_count(); ++point)
    for (int axis = 0; axis < 3; ++axis)
      columns.of_point.push_back(is_fixed(scene, point, axis) ? -1 : columns.count++);
  for (int line = 0; line < static_cast<int>(scene.problem().lines.size()); ++line) {
    const bool is_free = !scene.problem().is_fixed(scene.point_count() + line) &&
                         (scene.is_anchored() || line != scene.reference().line);
    columns.of_line.push_back(is_free ? columns.count : -1);
    columns.count += is_free ? 6 : 0;
    columns.free_lines += is_free ? 1 : 0;
  }
  return columns;
}

class Filler {
 public:
  Filler(const Columns& columns, int constraints)
      : columns_(columns),
        jacobian_(Eigen::MatrixXcd::Zero(constraints + 2 * columns.free_lines, columns.count)) {}

  void points(int row, int a, int b, const Eigen::Vector3cd& difference) {
    add_point(row, a, difference);
    add_point(row, b, -difference);
  }

  /// d²/2 = (w·w − (w·u)²)/2 with w from the line's point p to the point c.
  void point_and_line(int row, int point, int line, const Eigen::Vector3cd& c, const ComplexLine& at) {
    const Eigen::Vector3cd w = c - at.point;
    const Complex along = (w.transpose() * at.direction).value();
    const Eigen::Vector3cd across = w - along * at.direction;
    add_point(row, point, across);
    if (columns_.of_line[line] < 0) return;
    jacobian_.block<1, 3>(row, columns_.of_line[line]) = -across.transpose();
    jacobian_.block<1, 3>(row, columns_.of_line[line] + 3) = -along * across.transpose();
  }

  void normalisation(int row, int line, const Eigen::Vector3cd& direction) {
    jacobian_.block<1, 3>(row, columns_.of_line[line]) = direction.transpose();
    jacobian_.block<1, 3>(row + 1, columns_.of_line[line] + 3) = direction.transpose();
  }

  Eigen::MatrixXcd take() { return std::move(jacobian_); }

 private:
  void add_point(int row, int point, const Eigen::Vector3cd& gradient) {
    for (int axis = 0; axis < 3; ++axis)
      if (const int column = columns_.of_point[3 * point + axis]; column >= 0)
        jacobian_(row, column) = gradient[axis];
  }

  const Columns& columns_;
  Eigen::MatrixXcd jacobian_;
};

}  // namespace

Eigen::MatrixXcd line_jacobian(const Scene& scene, const Figure& figure) {
  const Columns columns = columns_of(scene);
  const ComplexPoints points = complex_points(figure);
  const std::vector<ComplexLine> lines = complex_lines(figure);
  Filler filler(columns, scene.constraint_count());
  int row = 0;
  for (const DistanceConstraint& constraint : scene.problem().constraints) {
    auto [a, b] = constraint.between;
    if (a > b) std::swap(a, b);  // points come first
    if (const int line = b - scene.point_count(); line < 0)
      filler.points(row, a, b, points.col(a) - points.col(b));
    else
      filler.point_and_line(row, a, line, points.col(a), lines[line]);
    ++row;
  }
  for (std::size_t line = 0; line < lines.size(); ++line) {
    if (columns.of_line[line] < 0) continue;
    filler.normalisation(row, static_cast<int>(line), lines[line].direction);
    row += 2;
  }
  return filler.take();
}

}  // namespace gcs
