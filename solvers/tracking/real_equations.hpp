#pragma once
/// The equations of a general scene at real unknowns, in doubles and in double-double.

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <utility>
#include <vector>

#include "solvers/model/distance_system.hpp"
#include "solvers/model/quadratic_system.hpp"

namespace gcs {

/// Σ terms + constant
struct RealForm {
  std::vector<std::pair<int, double>> terms;
  double constant = 0;

  /// What it changes by when x does.
  double change(const Eigen::Ref<const Eigen::VectorXd>& x) const;
  double at(const Eigen::VectorXd& x) const { return constant + change(x); }
  DoubleDouble wide_at(const Eigen::VectorXd& x) const;
  bool operator==(const RealForm&) const = default;
};

/// Σ left·right = given, one sum for each equation.
struct RealEquations {
  struct Product {
    Eigen::Index equation = 0;
    RealForm left, right;
  };

  int unknowns = 0;
  std::vector<Product> products;
  Eigen::VectorXd given;

  Eigen::Index count() const { return given.size(); }
  /// Σ left·right of all equations.
  Eigen::VectorXd sums(const Eigen::VectorXd& x) const;
  /// The same, right to some 2^-104 of their terms.
  std::vector<DoubleDouble> wide_sums(const Eigen::VectorXd& x) const;
  /// Their derivatives, into the first rows and columns.
  void jacobian(const Eigen::VectorXd& x, Eigen::MatrixXd& matrix) const;
};

/// What is given, and the unknowns, in double-double; and the same in doubles, for derivatives.
class WideEquations {
 public:
  /// Precondition: the coefficients are real.
  explicit WideEquations(const QuadraticSystem& system);

  const RealEquations& in_doubles() const { return in_doubles_; }
  /// Σ left·right − given of each equation, right to some 2^-100 of its terms.
  std::vector<DoubleDouble> excess(const std::vector<DoubleDouble>& x) const;
  /// The same, rounded.
  Eigen::VectorXd excess(const Eigen::VectorXd& x) const;

 private:
  struct Form {
    std::vector<std::pair<std::size_t, DoubleDouble>> terms;
    DoubleDouble constant;

    explicit Form(const LinearForm& form);
    DoubleDouble at(const std::vector<DoubleDouble>& x) const;
  };
  struct Product {
    std::size_t equation = 0;
    Form left, right;
  };

  RealEquations in_doubles_;
  std::vector<Product> products_;
  std::vector<DoubleDouble> given_;
};

Eigen::VectorXd real_parts(const std::vector<std::complex<double>>& values);

/// All of them but one.
RealEquations without(Eigen::Index equation, const RealEquations& equations);

/// Precondition: the coefficients are real.
RealEquations real_equations(const QuadraticSystem& system);

/// Newton's method from x, undamped, until its steps no longer fall: converged where the last one is at most `tolerance`
/// relative to 1 + the largest unknown. Precondition: as many equations as unknowns.
Refinement refine(const RealEquations& equations, double tolerance, Eigen::VectorXd& x);

}  // namespace gcs
