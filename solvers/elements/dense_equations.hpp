#pragma once
/// Quadratic systems evaluated in doubles, term by term as they are written: the slow way, for single figures.

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
EquationResiduals residuals_at(const QuadraticSystem& system, const std::vector<std::complex<double>>& x);

/// Equations × unknowns.
Eigen::MatrixXcd jacobian_at(const QuadraticSystem& system, const std::vector<std::complex<double>>& x);

/// The zero of these equations that the Gauss–Newton method leads to from x, to rounding, by the shortest steps where they
/// are fewer than the unknowns. Nothing where it does not settle, or so far off that rounding would count.
std::optional<std::vector<std::complex<double>>> zero_near(const QuadraticSystem& system,
                                                           const std::vector<int>& equations,
                                                           std::vector<std::complex<double>> x);

/// A point at random that solves these equations, to rounding, by the Gauss–Newton method. They may have components of
/// their own, such as lines through two points that are one: of some starts the one counts at which all equations of the
/// system have the highest rank, the first one of full rank. Nothing where no start leads to a zero.
std::optional<std::vector<std::complex<double>>> random_zero(const QuadraticSystem& system,
                                                             const std::vector<int>& equations,
                                                             std::mt19937_64& random);

}  // namespace gcs
