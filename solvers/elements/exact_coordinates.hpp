#pragma once
/// Exact coordinates of what a body has, in the basis that two of its directions make.

#include <vector>

#include "solvers/numeric/exact_number.hpp"
#include "solvers/numeric/rational_vector.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// The vector whose components are numbers of an element of a body, from `first` on, in a unit of 2^−exponent of the
/// file's.
RationalVector rational_vector(const BodyElement& element, std::size_t first, int dimension, int exponent);

/// numerator/‖parts‖. Precondition: not all parts are 0.
ExactNumber over_norm(const Rational& numerator, const std::vector<Rational>& parts);
/// v, and v/‖v‖, component by component. Precondition of the latter: v is not 0.
std::vector<ExactNumber> exact_numbers(const RationalVector& v);
std::vector<ExactNumber> unit_numbers(const RationalVector& v);
/// ‖v‖. Precondition: v is not 0.
ExactNumber exact_norm(const RationalVector& v);
/// How far a plane of a body is from a point of it, along its normal.
ExactNumber offset_from(const RationalVector& point, const BodyElement& plane, int exponent);

/// The basis u = d/‖d‖, w = e/‖e‖, u × w of vectors d and e that are not parallel.
class ExactBasis {
 public:
  ExactBasis(RationalVector d, RationalVector e);

  /// u·w
  ExactNumber cosine() const;
  /// a, b, c of v = a u + b w + c u × w; with `is_unit` of v/‖v‖.
  std::vector<ExactNumber> coordinates(const RationalVector& v, bool is_unit) const;

 private:
  RationalVector d_, e_;
  Rational dd_, de_, ee_;
};

}  // namespace gcs
