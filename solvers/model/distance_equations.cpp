#include "solvers/model/distance_equations.hpp"

#include <cstddef>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

/// Coordinate `axis` of the point a less that of b, which may be the line. Without terms where both are given.
LinearForm difference(const Scene& scene, const DistanceSystem& system, int a, int b, int axis) {
  LinearForm form;
  const int minuend = system.unknown(a, axis);
  if (minuend >= 0)
    form.terms.push_back({minuend});
  else
    form.constant = given_coordinate(scene, a, axis);
  if (system.is_line(b)) return form;
  const int subtrahend = system.unknown(b, axis);
  if (subtrahend >= 0)
    form.terms.push_back({subtrahend, exactly(-1)});
  else if (minuend >= 0)
    form.constant = negated(given_coordinate(scene, b, axis));
  return form;
}

}  // namespace

QuadraticEquation distance_equation(const Scene& scene, const DistanceSystem& system, int constraint) {
  const auto [a, b] = system.edges()[static_cast<std::size_t>(constraint)];
  QuadraticEquation equation{{}, given_square(scene, constraint)};
  for (int axis = system.is_line(b) ? 1 : 0; axis < system.dimension(); ++axis) {
    const LinearForm form = difference(scene, system, a, b, axis);
    if (!form.terms.empty()) equation.products.push_back({form, form});
  }
  return equation;
}

QuadraticSystem distance_equations(const Scene& scene, const DistanceSystem& system) {
  QuadraticSystem result{system.unknowns(), {}, mirror_axes(scene, system)};
  for (int e = 0; e < system.equations(); ++e)
    result.equations.push_back(distance_equation(scene, system, e));
  return result;
}

}  // namespace gcs
