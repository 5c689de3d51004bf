#pragma once
/// A system of quadratic equations in doubles, for boxes: forms that are linear in the unknowns, and equations
/// that sum products of them. Every number of the system is enclosed.

#include <vector>

#include "solvers/model/quadratic_system.hpp"
#include "solvers/numeric/double_double.hpp"
#include "solvers/numeric/interval.hpp"

namespace gcs {

/// An interval for every unknown.
using IntervalBox = std::vector<Interval>;

/// A number that is known to 2^-104, relative to it.
struct EnclosedNumber {
  DoubleDouble value;
  Interval interval;
};

struct IntervalForm {
  struct Term {
    int unknown = 0;
    EnclosedNumber coefficient;
  };
  std::vector<Term> terms;
  EnclosedNumber constant;

  /// Its values on a box.
  Interval over(const IntervalBox& box) const;
};

/// Two forms by their numbers; a square where they are the same.
struct IntervalProduct {
  int left = 0;
  int right = 0;

  bool is_square() const { return left == right; }
};

/// Σ products = given
struct IntervalEquation {
  std::vector<IntervalProduct> products;
  EnclosedNumber given;
};

struct IntervalEquations {
  explicit IntervalEquations(const QuadraticSystem& system);

  int unknowns = 0;
  std::vector<IntervalForm> forms;  ///< distinct
  std::vector<IntervalEquation> equations;
  /// Of each unknown, whether it is in a product whose other form is no constant.
  std::vector<bool> is_nonlinear;
};

}  // namespace gcs
