#include "solvers/homotopies/start_store.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

/// Of Σ (u − v)² − A, relative to the sum of what it is made of: a solution to the last digit leaves some
/// 1e-15, and one with an error in any digit that matters to the tracker far more.
constexpr double residual_limit = 1e-10;

/// The largest residual of an equation, relative to its terms; infinite where one is no finite number.
double relative_residual(const SquareSystem& system, const ComplexVectorX& x, const ComplexVectorX& squares) {
  const ComplexVectorX found = squares_at(system, x);
  double largest_residual = 0;
  for (int e = 0; e < system.equations(); ++e) {
    double size = std::abs(squares[e]);
    for (int d = system.first[e]; d < system.first[e + 1]; ++d) {
      const auto [minuend, subtrahend, constant] = system.differences[d];
      size += std::norm(x[minuend] - (subtrahend < 0 ? constant : x[subtrahend]));
    }
    const double residual = std::abs(found[e] - squares[e]) / size;
    if (!std::isfinite(residual)) return std::numeric_limits<double>::infinity();
    largest_residual = std::max(largest_residual, residual);
  }
  return largest_residual;
}

}  // namespace

std::optional<StartDefect> find_defect(const LengthFamily& family, const GenericSolutions& generic) {
  std::mt19937_64 random(1);  // for keys of a set, which change no answer
  SolutionSet known(family.signs, random);
  for (std::size_t i = 0; i < generic.solutions.size(); ++i) {
    const int number = static_cast<int>(i);
    const ComplexVectorX& x = generic.solutions[i];
    if (relative_residual(family.system, x, generic.squares) > residual_limit)
      return StartDefect{number, "this is no solution for the generic squared lengths"};
    if (const int twin = known.insert(x, 0); twin != number)
      return StartDefect{number, "this is solution " + std::to_string(twin) + " again, up to reflection"};
  }
  return std::nullopt;
}

}  // namespace gcs
