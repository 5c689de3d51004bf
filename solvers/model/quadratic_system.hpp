#pragma once
/// Square systems of quadratic equations with exactly known coefficients.

#include <vector>

#include "solvers/numeric/exact_number.hpp"
#include "solvers/numeric/sign_masks.hpp"

namespace gcs {

/// coefficient·x[unknown]
struct ScaledUnknown {
  int unknown = 0;
  ExactNumber coefficient = exactly(1);
};

/// Σ terms + constant
struct LinearForm {
  std::vector<ScaledUnknown> terms;
  ExactNumber constant{};
};

struct FormProduct {
  LinearForm left;
  LinearForm right;
};

/// Σ left·right = given
struct QuadraticEquation {
  std::vector<FormProduct> products;
  ExactNumber given{};
};

/// As many equations as unknowns.
struct QuadraticSystem {
  int unknowns = 0;
  std::vector<QuadraticEquation> equations;
  SignMasks mirror;  ///< changes of signs that lead from solutions to solutions that are not counted apart
};

}  // namespace gcs
