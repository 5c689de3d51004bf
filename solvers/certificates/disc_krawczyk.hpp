#pragma once
/// Krawczyk's test in double precision for products of complex discs: many times faster than in balls.

#include <complex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "solvers/certificates/interval_equations.hpp"
#include "solvers/certificates/squared_differences.hpp"
#include "solvers/model/enclosure.hpp"
#include "solvers/model/quadratic_system.hpp"

namespace gcs {

class DiscKrawczyk {
 public:
  /// Nothing where a form has complex coefficients or more terms, or an equation more products, than rounding is bounded
  /// for.
  static std::optional<DiscKrawczyk> of(const QuadraticSystem& system);

  /// The solution next to x, if double precision proves that there is one. `is_real`: x and the system are, and the test
  /// takes place in real numbers.
  std::optional<Enclosure> prove(const std::vector<std::complex<double>>& x, bool is_real) const;

 private:
  using System = std::variant<SquaredDifferences, IntervalEquations>;
  explicit DiscKrawczyk(System system) : system_(std::move(system)) {}

  System system_;
};

}  // namespace gcs
