#include "solvers/reduction/precise_base.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/certificates/scene_equations.hpp"

namespace gcs {
namespace {

constexpr slong bits = 256;

Rational midpoint(const BallMatrix& x, int unknown) {
  fmpq_t value;
  fmpq_init(value);
  arf_get_fmpq(value, arb_midref(acb_realref(x(unknown, 0))));
  Rational result = Rational::from_raw(value);
  fmpq_clear(value);
  return result;
}

double largest_radius(const BallMatrix& x) {
  double radius = 0;
  for (slong i = 0; i < x.rows(); ++i) radius = std::max(radius, mag_get_d(arb_radref(acb_realref(x(i, 0)))));
  return radius;
}

}  // namespace

std::optional<MeasuredSquares> precise_base(const Scene& scene, const PartProblem& part,
                                            const Simplex& places, const std::vector<int>& base) {
  const Scene alone(part.problem);
  if (!places.imag().isZero(0) || why_not_certified(alone)) return std::nullopt;
  const SceneEquations equations(alone);
  const int smaller = alone.unit_exponent() - scene.unit_exponent();
  const Figure figure = Figure{places.real(), {}}.scaled(-smaller);
  const auto proof = Certifier(equations.system()).prove(equations.coordinates(alone.in_frame(figure)), bits);
  if (!proof) return std::nullopt;
  const auto coordinate = [&](int point, int axis) {
    const auto place = std::find(part.points.begin(), part.points.end(), point) - part.points.begin();
    const int unknown = equations.point_unknown(static_cast<int>(place), axis);
    return unknown < 0 ? Rational(0) : midpoint(proof->solution, unknown);
  };
  MeasuredSquares result;
  double shortest = std::numeric_limits<double>::infinity();
  for (int pair = 0; pair < pairs_in(scene.dimension()); ++pair) {
    const auto& [a, b] = base_pairs[pair];
    Rational square;
    for (int axis = 0; axis < scene.dimension(); ++axis) {
      const Rational along = coordinate(base[b], axis) - coordinate(base[a], axis);
      square = square + along * along;
    }
    shortest = std::min(shortest, square.approximate_root());
    result.squares[pair] = square.times_power_of_two(2 * smaller);
  }
  result.error = 8 * largest_radius(proof->solution) / shortest;  // 4·√3 < 8, to first order
  return result.error < 1 ? std::optional(result) : std::nullopt;
}

}  // namespace gcs
