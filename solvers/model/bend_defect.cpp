#include "solvers/model/bend_defect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "solvers/numeric/positive_polynomial.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

/// Below every decimal whose nearest double this is.
Rational below(double nearest) {
  return Rational::from_double(nearest) -
         Rational::from_double(std::abs(nearest)) * Rational::from_double(epsilon) -
         Rational::from_double(std::numeric_limits<double>::denorm_min());
}

/// Each coordinate is off by half a rounding of itself, their differences and the norm by some more of theirs.
Rational sketched_below(const ProblemStatement& problem, const DistanceConstraint& constraint) {
  const auto a = problem.sketch->points.col(constraint.between[0]),
             b = problem.sketch->points.col(constraint.between[1]);
  const Rational rounding = Rational::from_double(16 * epsilon);
  const Rational length = Rational::from_double((a - b).stableNorm());
  const Rational size =
      Rational::from_double(a.cwiseAbs().maxCoeff()) + Rational::from_double(b.cwiseAbs().maxCoeff());
  return length - rounding * (length + size);
}

Rational given_below(const DistanceConstraint& constraint) {
  const Rational length = Rational::from_double(constraint.length());
  return length - length * Rational::from_double(4 * epsilon);
}

/// (1 − t)·a_sk + t·a_so + t(1 − t)·Σ c_i t^i in powers of t, for the lower bounds.
std::vector<Rational> lower_polynomial(const ProblemStatement& problem, const BentLength& bent) {
  const DistanceConstraint& constraint = problem.constraints[bent.constraint];
  const Rational at_sketch = sketched_below(problem, constraint), at_target = given_below(constraint);
  std::vector<Rational> powers(bent.coefficients.size() + 2);
  powers[0] = at_sketch;
  powers[1] = at_target - at_sketch;
  for (std::size_t i = 0; i < bent.coefficients.size(); ++i) {
    const Rational c = below(bent.coefficients[i]);
    powers[i + 1] = powers[i + 1] + c;
    powers[i + 2] = powers[i + 2] - c;
  }
  return powers;
}

}  // namespace

std::optional<BendDefect> bend_defect(const ProblemStatement& problem, const BentLength& bent) {
  constexpr std::size_t most = BentLength::most_coefficients;
  const DistanceConstraint& constraint = problem.constraints[bent.constraint];
  if (bent.coefficients.size() > most)
    return BendDefect{fmt::format("there are {} coefficients", bent.coefficients.size()),
                      fmt::format("give at most {}", most)};
  if (!std::ranges::all_of(bent.coefficients, [](double c) { return std::isfinite(c); }))
    return BendDefect{"a coefficient is not finite", "give numbers"};
  const auto [a, b] = constraint.between;
  if (!problem.sketch || !problem.is_point(a) || !problem.is_point(b)) return std::nullopt;
  const auto t = where_not_positive(lower_polynomial(problem, bent));
  if (!t) return std::nullopt;
  return BendDefect{fmt::format("the length of '{}' is not positive near t = {:.3g}", constraint.id, *t),
                    "give coefficients that keep it above 0 for t from 0 to 1"};
}

}  // namespace gcs
