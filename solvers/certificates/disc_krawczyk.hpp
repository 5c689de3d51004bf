#pragma once
/// Krawczyk's test in double precision for products of complex discs: fast, for systems whose equations are
/// sums of squares of unknowns and of differences of two, as distances are.

#include <Eigen/Core>
#include <array>
#include <complex>
#include <optional>
#include <vector>

#include "solvers/certificates/enclosure.hpp"
#include "solvers/certificates/krawczyk_image.hpp"
#include "solvers/model/quadratic_system.hpp"
#include "solvers/numeric/complex_double_double.hpp"

namespace gcs {

class DiscKrawczyk {
 public:
  /// Nothing where an equation has another form or a left side with a constant.
  static std::optional<DiscKrawczyk> of(const QuadraticSystem& system);

  /// The solution next to x, if double precision proves that there is one. `is_real`: x is, and the test
  /// takes place in real numbers.
  std::optional<Enclosure> prove(const std::vector<std::complex<double>>& x, bool is_real) const;

 private:
  /// Σ (x[pair[0]] − x[pair[1]])² = given, where x[−1] = 0.
  struct Equation {
    std::vector<std::array<int, 2>> pairs;
    ComplexDoubleDouble given;  ///< right to 2^-100 of its size
  };

  template <typename Scalar>
  LinearisedSystem<Scalar> linearised(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x) const;
  template <typename Scalar>
  std::optional<Enclosure> prove(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& x) const;

  std::vector<Equation> equations_;
  Eigen::MatrixXd curvature_;  ///< how far the entries of the Jacobian move when every x_i moves by 1
};

}  // namespace gcs
