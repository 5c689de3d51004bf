#include "solvers/polyhedral/supports.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>

#include "solvers/lanes/square_system.hpp"
#include "solvers/model/distance_system.hpp"

namespace gcs {
namespace {

/// The product of some unknowns.
Exponents monomial(int unknowns, std::initializer_list<int> factors) {
  Exponents exponents(static_cast<std::size_t>(unknowns), 0);
  for (const int factor : factors) ++exponents[factor];
  return exponents;
}

/// One polynomial of the system, term by term.
class Polynomial {
 public:
  Polynomial(SparseEquations& equations, int unknowns)
      : unknowns_(unknowns),
        support_(equations.supports.emplace_back()),
        coefficients_(equations.coefficients.emplace_back()) {}

  void add(std::initializer_list<int> factors, std::complex<double> coefficient) {
    support_.push_back(monomial(unknowns_, factors));
    coefficients_.push_back(coefficient);
  }

 private:
  int unknowns_;
  Support& support_;
  ComplexVectorX& coefficients_;
};

/// Which points and coordinates the formulation with spheres takes as known.
class SphereUnknowns {
 public:
  SphereUnknowns(const DistanceSystem& system, const ComplexVectorX& x);

  int count() const { return count_; }
  /// The line is known as well.
  bool is_known(int entity) const { return system_.is_line(entity) || sphere_[entity] < 0; }
  int sphere(int point) const { return sphere_[point]; }
  /// −1 where the coordinate is known.
  int coordinate(int point, int axis) const { return coordinate_[3 * point + axis]; }
  bool is_zero(int point, int axis) const {
    return system_.unknown(point, axis) < 0 && system_.given_coordinate(point, axis) == 0;
  }
  /// As the placement has it.
  std::complex<double> value(int point, int axis) const {
    const int i = system_.unknown(point, axis);
    return i < 0 ? system_.given_coordinate(point, axis) : x_[i];
  }

 private:
  bool determines_reference() const;
  bool is_known_by(bool reference_is_known, int point) const;

  const DistanceSystem& system_;
  const ComplexVectorX& x_;
  int count_ = 0;
  std::vector<int> coordinate_;
  std::vector<int> sphere_;  ///< −1: the point is known
};

SphereUnknowns::SphereUnknowns(const DistanceSystem& system, const ComplexVectorX& x)
    : system_(system),
      x_(x),
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
void add_sphere(const SphereUnknowns& unknowns, int dimension, int point, SparseEquations& equations) {
  Polynomial polynomial(equations, unknowns.count());
  polynomial.add({unknowns.sphere(point)}, 1);
  for (int axis = 0; axis < dimension; ++axis)
    if (const int x = unknowns.coordinate(point, axis); x >= 0) polynomial.add({x, x}, -1);
}

/// s_j − x_j² − A.
void add_line(const SphereUnknowns& unknowns, int point, std::complex<double> square,
              SparseEquations& equations) {
  Polynomial polynomial(equations, unknowns.count());
  polynomial.add({unknowns.sphere(point)}, 1);
  if (const int x = unknowns.coordinate(point, 0); x >= 0) polynomial.add({x, x}, -1);
  polynomial.add({}, -square);
}

/// s_j + s_k − 2 p_j·p_k − A. Precondition: p_j is not known.
void add_edge(const SphereUnknowns& unknowns, int dimension, int j, int k, std::complex<double> square,
              SparseEquations& equations) {
  Polynomial polynomial(equations, unknowns.count());
  polynomial.add({unknowns.sphere(j)}, 1);
  std::complex<double> constant = -square;
  if (!unknowns.is_known(k)) polynomial.add({unknowns.sphere(k)}, 1);
  for (int axis = 0; axis < dimension; ++axis) {
    const int x = unknowns.coordinate(j, axis), y = unknowns.coordinate(k, axis);
    if (x >= 0 && y >= 0) polynomial.add({x, y}, -2);
    if (x >= 0 && y < 0 && !unknowns.is_zero(k, axis)) polynomial.add({x}, -2.0 * unknowns.value(k, axis));
    if (x < 0 && y >= 0 && !unknowns.is_zero(j, axis)) polynomial.add({y}, -2.0 * unknowns.value(j, axis));
    if (unknowns.is_known(k)) constant += unknowns.value(k, axis) * unknowns.value(k, axis);
  }
  polynomial.add({}, constant);
}

/// Which unknown each unknown coordinate of the frame is.
std::vector<int> numbers_of(const DistanceSystem& system, const SphereUnknowns& unknowns) {
  std::vector<int> numbers(static_cast<std::size_t>(system.unknowns()), -1);
  for (int point = 0; point < system.point_count(); ++point)
    for (int axis = 0; axis < system.dimension(); ++axis)
      if (const int i = system.unknown(point, axis); i >= 0) numbers[i] = unknowns.coordinate(point, axis);
  return numbers;
}

}  // namespace

SparseEquations coordinate_equations(const SquareSystem& system, const ComplexVectorX& x) {
  const int n = system.unknowns;
  const ComplexVectorX squares = squares_at(system, x);
  SparseEquations equations;
  for (int e = 0; e < system.equations(); ++e) {
    Polynomial polynomial(equations, n);
    std::complex<double> rest = system.given[e] - squares[e];
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [u, v, constant] = system.differences[d];
      polynomial.add({u, u}, 1);
      if (v >= 0) {
        polynomial.add({v, v}, 1);
        polynomial.add({u, v}, -2);
      } else if (constant != 0) {
        polynomial.add({u}, -2 * constant);
        rest += constant * constant;
      }
    }
    polynomial.add({}, rest);
  }
  for (int i = 0; i < n; ++i) equations.unknown_of.push_back(i);
  return equations;
}

SparseEquations sphere_equations(const DistanceSystem& system, const ComplexVectorX& x) {
  const SphereUnknowns unknowns(system, x);
  const int dimension = system.dimension();
  const ComplexVectorX squares = squares_at(square_system(system), x);
  SparseEquations equations;
  equations.unknown_of = numbers_of(system, unknowns);
  for (int point = 0; point < system.point_count(); ++point)
    if (!unknowns.is_known(point)) add_sphere(unknowns, dimension, point, equations);
  for (int e = 0; e < system.equations(); ++e) {
    const auto [a, b] = system.edges()[e];
    if (unknowns.is_known(a) && unknowns.is_known(b)) continue;
    const bool swapped = unknowns.is_known(a);
    if (system.is_line(b))
      add_line(unknowns, a, squares[e], equations);
    else
      add_edge(unknowns, dimension, swapped ? b : a, swapped ? a : b, squares[e], equations);
  }
  return equations;
}

}  // namespace gcs
