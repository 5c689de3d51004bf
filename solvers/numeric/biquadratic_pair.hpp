#pragma once
/// Two polynomials of degree 2 in x and 2 in y each: all their common zeros at once, as an eigenvalue
/// problem.
///
/// Both are quadratics in y whose coefficients are quadratics in x, so their Sylvester matrix in y is a 4 × 4
/// matrix polynomial S(x) = S_0 + S_1 x + S_2 x², singular at the x of the common zeros; by Bézout's theorem
/// on P¹ × P¹ there are 8. The eigenvalues of its companion form are these x. Both projective lines are
/// turned by a fixed angle first, so that a zero at infinity is an eigenvalue like any other and S_2 is
/// regular unless the two polynomials have a common factor. Gohberg, Lancaster, Rodman, Matrix Polynomials,
/// 1982, chapter 1.

#include <Eigen/Core>
#include <array>
#include <complex>
#include <vector>

namespace gcs {

/// Σ c(i, j) x^i y^j.
using Biquadratic = Eigen::Matrix3d;

/// The largest i + j of a coefficient that is not 0, in x and y together; −1: there is none.
int degree(const Biquadratic& p);

/// p(x + dx, y + dy).
Biquadratic shifted(const Biquadratic& p, double dx, double dy);

/// A point of P¹ as (numerator, denominator) of 2-norm 1: at infinity where the denominator vanishes.
struct ProjectiveNumber {
  std::complex<double> numerator;
  std::complex<double> denominator;

  std::complex<double> value() const { return numerator / denominator; }
  /// |1/x| of a large x: how near it is to infinity.
  double nearness_to_infinity() const { return std::abs(denominator); }
};

struct CommonZero {
  ProjectiveNumber x, y;
};

struct CommonZeros {
  /// One entry for each of the eight eigenvalues, or roots of the resultant in y: the y that go with it, one as a rule, two where both zeros
  /// in y of one polynomial are zeros of the other to 1e-6 (a double x, or nearly so).
  std::array<std::vector<CommonZero>, 8> of_eigenvalue;
  /// The polynomials have a common factor, to rounding: their zeros are a curve.
  bool common_factor = false;
};

/// Coefficients of each polynomial are to be of order 1 at most. The error of a simple zero is of the order
/// of rounding times its condition, of a double one the square root of that.
CommonZeros common_zeros(const Biquadratic& p, const Biquadratic& q);

/// The same with the x of the zeros given, each as often as it is one. The entries that are left are empty.
/// Precondition: there are eight at most.
CommonZeros common_zeros_over(const std::vector<std::complex<double>>& xs, const Biquadratic& p,
                              const Biquadratic& q);

}  // namespace gcs
