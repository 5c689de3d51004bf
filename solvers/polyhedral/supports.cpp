#include "solvers/polyhedral/supports.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "solvers/complex_tracking/square_system.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {
namespace {

/// The product of some unknowns.
Exponents monomial(int unknowns, std::initializer_list<int> factors) {
  Exponents exponents(static_cast<std::size_t>(unknowns), 0);
  for (const int factor : factors) ++exponents[factor];
  return exponents;
}

/// Which points and coordinates the formulation with spheres takes as known.
class SphereUnknowns {
 public:
  explicit SphereUnknowns(const DistanceSystem& system);

  int count() const { return count_; }
  /// The line is known as well.
  bool is_known(int entity) const { return system_.is_line(entity) || sphere_[entity] < 0; }
  int sphere(int point) const { return sphere_[point]; }
  /// −1 where the coordinate is known.
  int coordinate(int point, int axis) const { return coordinate_[3 * point + axis]; }
  bool is_zero(int point, int axis) const {
    return system_.unknown(point, axis) < 0 && system_.given_coordinate(point, axis) == 0;
  }

 private:
  bool determines_reference() const;
  bool is_known_by(bool reference_is_known, int point) const;

  const DistanceSystem& system_;
  int count_ = 0;
  std::vector<int> coordinate_;
  std::vector<int> sphere_;  ///< −1: the point is known
};

SphereUnknowns::SphereUnknowns(const DistanceSystem& system)
    : system_(system),
      coordinate_(3 * static_cast<std::size_t>(system.point_count()), -1),
      sphere_(static_cast<std::size_t>(system.point_count()), -1) {
  const bool reference_is_known = determines_reference();
  for (int point = 0; point < system.point_count(); ++point) {
    if (is_known_by(reference_is_known, point)) continue;
    for (int axis = 0; axis < system.dimension(); ++axis)
      if (system.unknown(point, axis) >= 0) coordinate_[3 * point + axis] = count_++;
    sphere_[point] = count_++;
  }
}

/// Whether every two entities of the reference have their distance given.
bool SphereUnknowns::determines_reference() const {
  const Reference& reference = system_.reference();
  std::vector<int> entities;
  for (const int point : {reference.origin, reference.axis, reference.plane, reference.height})
    if (point >= 0) entities.push_back(point);
  if (reference.line >= 0) entities.push_back(system_.point_count());
  const auto is_within = [&](const std::array<int, 2>& edge) {
    return std::count(entities.begin(), entities.end(), edge[0]) +
               std::count(entities.begin(), entities.end(), edge[1]) ==
           2;
  };
  const auto& edges = system_.edges();
  return std::count_if(edges.begin(), edges.end(), is_within) ==
         static_cast<std::ptrdiff_t>(entities.size() * (entities.size() - 1) / 2);
}

/// Without a frame, that is when the file fixes points, a reference is but a hint: its free points are not
/// known.
bool SphereUnknowns::is_known_by(bool reference_is_known, int point) const {
  int unknown = 0;
  for (int axis = 0; axis < system_.dimension(); ++axis) unknown += system_.unknown(point, axis) >= 0;
  if (unknown == 0 || unknown == system_.dimension() || !reference_is_known) return unknown == 0;
  const Reference& reference = system_.reference();
  return point == reference.axis || point == reference.plane || point == reference.height;
}

/// s_j − p_j·p_j.
Support sphere_equation(const SphereUnknowns& unknowns, int dimension, int point) {
  Support support{monomial(unknowns.count(), {unknowns.sphere(point)})};
  for (int axis = 0; axis < dimension; ++axis)
    if (const int x = unknowns.coordinate(point, axis); x >= 0)
      support.push_back(monomial(unknowns.count(), {x, x}));
  return support;
}

/// s_j − x_j² − A.
Support line_equation(const SphereUnknowns& unknowns, int point) {
  Support support{monomial(unknowns.count(), {unknowns.sphere(point)})};
  if (const int x = unknowns.coordinate(point, 0); x >= 0)
    support.push_back(monomial(unknowns.count(), {x, x}));
  support.push_back(monomial(unknowns.count(), {}));
  return support;
}

/// s_j + s_k − 2 p_j·p_k − A. Precondition: p_j is not known.
Support edge_equation(const SphereUnknowns& unknowns, int dimension, int j, int k) {
  const int n = unknowns.count();
  Support support{monomial(n, {unknowns.sphere(j)})};
  if (!unknowns.is_known(k)) support.push_back(monomial(n, {unknowns.sphere(k)}));
  for (int axis = 0; axis < dimension; ++axis) {
    const int x = unknowns.coordinate(j, axis), y = unknowns.coordinate(k, axis);
    if (x >= 0 && y >= 0) support.push_back(monomial(n, {x, y}));
    if (x >= 0 && y < 0 && !unknowns.is_zero(k, axis)) support.push_back(monomial(n, {x}));
    if (x < 0 && y >= 0 && !unknowns.is_zero(j, axis)) support.push_back(monomial(n, {y}));
  }
  support.push_back(monomial(n, {}));
  return support;
}

}  // namespace

Supports coordinate_supports(const SquareSystem& system) {
  const int n = system.unknowns;
  Supports supports;
  for (int e = 0; e < system.equations(); ++e) {
    Support& support = supports.emplace_back();
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [u, v, constant] = system.differences[d];
      support.push_back(monomial(n, {u, u}));
      if (v >= 0) support.insert(support.end(), {monomial(n, {v, v}), monomial(n, {u, v})});
      if (v < 0 && constant != 0) support.push_back(monomial(n, {u}));
    }
    support.push_back(monomial(n, {}));
  }
  return supports;
}

Supports sphere_supports(const DistanceSystem& system) {
  const SphereUnknowns unknowns(system);
  const int dimension = system.dimension();
  Supports supports;
  for (int point = 0; point < system.point_count(); ++point)
    if (!unknowns.is_known(point)) supports.push_back(sphere_equation(unknowns, dimension, point));
  for (const auto& [a, b] : system.edges()) {
    if (unknowns.is_known(a) && unknowns.is_known(b)) continue;
    const bool swapped = unknowns.is_known(a);
    supports.push_back(system.is_line(b)
                           ? line_equation(unknowns, a)
                           : edge_equation(unknowns, dimension, swapped ? b : a, swapped ? a : b));
  }
  return supports;
}

}  // namespace gcs
