#pragma once
/// A system of quadratic equations in doubles, for boxes: forms that are linear in the unknowns, and equations
/// that sum products of them. Every number of the system is enclosed.

#include <Eigen/Core>
#include <vector>

#include "solvers/certificates/krawczyk_image.hpp"
#include "solvers/model/quadratic_system.hpp"
#include "solvers/numeric/complex_double_double.hpp"
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
  EnclosedNumber given;               ///< its real part
  DoubleDouble imaginary_given = {};  ///< right to 2^-104, relative to it
};

struct IntervalEquations {
  /// Precondition: the coefficients and constants of all forms are real.
  explicit IntervalEquations(const QuadraticSystem& system);

  int unknowns = 0;
  std::vector<IntervalForm> forms;  ///< distinct
  std::vector<IntervalEquation> equations;
  /// Of each unknown, whether it is in a product whose other form is no constant.
  std::vector<bool> is_nonlinear;
};

/// At a point, in double-double. Forms have a hundred terms and equations a hundred products at most. Scalar: double, where
/// what is given is real, or std::complex<double>.
template <typename Scalar>
LinearisedSystem<Scalar> linearised(const IntervalEquations& system,
                                    const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x);

/// How far the entries of the Jacobian move within |x_i − mid_i| ≤ radius_i, and are off at x by rounding.
template <typename Scalar>
Eigen::MatrixXd jacobian_radius(const IntervalEquations& system,
                                const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x,
                                const Eigen::VectorXd& radius);

}  // namespace gcs
