#pragma once
/// Of what tests make quadratic systems.

#include <string>
#include <utility>
#include <vector>

#include "solvers/model/quadratic_system.hpp"

namespace gcs {

/// factor·x_i + constant
inline LinearForm unknown(int i, double factor = 1, double constant = 0) {
  return {{{i, exactly(factor)}}, exactly(constant)};
}

inline ExactNumber decimal(const std::string& text) {
  ExactNumber number;
  number.decimal = text;
  return number;
}

inline LinearForm number(double value) { return {{}, exactly(value)}; }

/// No changes of signs lead from solutions to others.
inline QuadraticSystem square_system(std::vector<QuadraticEquation> equations) {
  const auto unknowns = equations.size();
  return {static_cast<int>(unknowns), std::move(equations), SignMasks(std::vector<SignMask>(unknowns, 0))};
}

}  // namespace gcs
