#include "solvers/reading/element_position.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace gcs {
namespace {

/// Sines below this are those of parallel elements. As far as this may positions disagree that are given twice.
constexpr double parallel_sine = 1e-9;

double distance_of_lines(const LinePosition& a, const LinePosition& b) {
  const Eigen::Vector3d normal = a.direction.cross(b.direction);
  const Eigen::Vector3d between = b.point - a.point;
  return normal.norm() <= parallel_sine ? between.cross(a.direction).stableNorm()
                                        : std::abs(between.dot(normal)) / normal.norm();
}

double height(const Eigen::Vector3d& point, const PlanePosition& plane) {
  return plane.normal.dot(point) - plane.offset;
}

/// Of two elements, the kind of the first not after that of the second in ElementPosition.
class Measuring {
 public:
  using Measures = std::vector<Measure>;

  Measures operator()(const Eigen::Vector3d& a, const Eigen::Vector3d& b) const {
    return {{true, (a - b).stableNorm()}};
  }
  Measures operator()(const Eigen::Vector3d& point, const LinePosition& line) const {
    return {{true, (point - line.point).cross(line.direction).stableNorm()}};
  }
  Measures operator()(const Eigen::Vector3d& point, const PlanePosition& plane) const {
    return {{true, height(point, plane)}};
  }
  Measures operator()(const LinePosition& a, const LinePosition& b) const {
    return {{false, std::abs(a.direction.dot(b.direction))}, {true, distance_of_lines(a, b)}};
  }
  Measures operator()(const LinePosition& line, const PlanePosition& plane) const {
    const double sine = std::abs(line.direction.dot(plane.normal));
    Measures result{{false, sine}};
    if (sine <= parallel_sine) result.push_back({true, height(line.point, plane)});
    return result;
  }
  Measures operator()(const PlanePosition& a, const PlanePosition& b) const {
    const double cosine = a.normal.dot(b.normal);
    Measures result{{false, cosine}};
    if (a.normal.cross(b.normal).norm() <= parallel_sine)
      result.push_back({true, b.offset * (cosine > 0 ? 1 : -1) - a.offset});
    return result;
  }
  template <typename A, typename B>
  Measures operator()(const A& a, const B& b) const {
    return (*this)(b, a);
  }
};

}  // namespace

std::vector<Measure> measures(const ElementPosition& a, const ElementPosition& b) {
  return std::visit(Measuring(), a, b);
}

}  // namespace gcs
