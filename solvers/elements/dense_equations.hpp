#pragma once
/// Quadratic systems evaluated in doubles, term by term as they are written, at single figures.

#include <Eigen/Core>
#include <optional>
#include <random>
#include <vector>

#include "solvers/elements/element_forms.hpp"

namespace gcs {

/// Σ left·right − given of every equation, and the sizes of its terms together.
struct EquationResiduals {
  Eigen::VectorXcd value;
  Eigen::VectorXd size;
};

/// A system with its numbers, which are exact, rounded to doubles once.
class DenseEquations {
 public:
  explicit DenseEquations(const QuadraticSystem& system);

  int unknowns() const { return unknowns_; }
  int count() const { return static_cast<int>(rows_.size()); }
  EquationResiduals residuals(const std::vector<std::complex<double>>& x) const;
  /// Equations × unknowns.
  Eigen::MatrixXcd jacobian(const std::vector<std::complex<double>>& x) const;

 private:
  struct Term {
    int unknown = 0;
    std::complex<double> coefficient;
  };
  struct Form {
    explicit Form(const LinearForm& form);
    std::complex<double> at(const std::vector<std::complex<double>>& x) const;

    std::vector<Term> terms;
    std::complex<double> constant;
  };
  struct Product {
    Form left, right;
  };
  struct Row {
    std::vector<Product> products;
    std::complex<double> given;
  };

  int unknowns_;
  std::vector<Row> rows_;
};

/// With as many unknowns held at x as leave so many free, those on which the others depend best.
QuadraticSystem held_at(QuadraticSystem system, const std::vector<std::complex<double>>& x, int free);

/// The zero of these equations that the Gauss–Newton method leads to from x, to rounding, by the shortest steps where they
/// are fewer than the unknowns. Nothing where it does not settle, or so far off that rounding would count.
std::optional<std::vector<std::complex<double>>> zero_near(const DenseEquations& system,
                                                           const std::vector<int>& equations,
                                                           std::vector<std::complex<double>> x);

/// A point at random that solves these equations, to rounding, by the Gauss–Newton method. They may have components of
/// their own, such as lines through two points that are one: of some starts the one counts at which all equations of the
/// system have the highest rank, the first one of full rank. Nothing where no start leads to a zero.
std::optional<std::vector<std::complex<double>>> random_zero(const DenseEquations& system,
                                                             const std::vector<int>& equations,
                                                             std::mt19937_64& random);

}  // namespace gcs
