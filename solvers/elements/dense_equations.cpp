#include "solvers/elements/dense_equations.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace gcs {
EquationResiduals residuals_at(const QuadraticSystem& system, const std::vector<std::complex<double>>& x) {
  const auto n = static_cast<Eigen::Index>(system.equations.size());
  EquationResiduals result{Eigen::VectorXcd::Zero(n), Eigen::VectorXd::Zero(n)};
  for (Eigen::Index e = 0; e < n; ++e) {
    const QuadraticEquation& equation = system.equations[static_cast<std::size_t>(e)];
    result.value[e] = -rounded_to_double(equation.given);
    result.size[e] = std::abs(result.value[e]);
    for (const FormProduct& product : equation.products) {
      const std::complex<double> term = value_at(product.left, x) * value_at(product.right, x);
      result.value[e] += term;
      result.size[e] += std::abs(term);
    }
  }
  return result;
}

Eigen::MatrixXcd jacobian_at(const QuadraticSystem& system, const std::vector<std::complex<double>>& x) {
  Eigen::MatrixXcd result =
      Eigen::MatrixXcd::Zero(static_cast<Eigen::Index>(system.equations.size()), system.unknowns);
  const auto add = [&](Eigen::Index row, const LinearForm& form, std::complex<double> factor) {
    for (const ScaledUnknown& term : form.terms)
      result(row, term.unknown) += rounded_to_double(term.coefficient) * factor;
  };
  for (std::size_t e = 0; e < system.equations.size(); ++e)
    for (const FormProduct& product : system.equations[e].products) {
      add(static_cast<Eigen::Index>(e), product.left, value_at(product.right, x));
      add(static_cast<Eigen::Index>(e), product.right, value_at(product.left, x));
    }
  return result;
}

std::optional<std::vector<std::complex<double>>> zero_near(const QuadraticSystem& system,
                                                           const std::vector<int>& equations,
                                                           std::vector<std::complex<double>> x) {
  constexpr int most_iterations = 60;
  constexpr double settled = 1e-14, far = 1e3;
  Eigen::Map<Eigen::VectorXcd> point(x.data(), system.unknowns);
  for (int i = 0; i < most_iterations && point.allFinite(); ++i) {
    const EquationResiduals here = residuals_at(system, x);
    if ((here.value(equations).cwiseAbs().array() <= settled * (1 + here.size(equations).array())).all())
      return point.lpNorm<Eigen::Infinity>() <= far ? std::optional(x) : std::nullopt;
    const Eigen::MatrixXcd jacobian = jacobian_at(system, x)(equations, Eigen::all);
    point -= jacobian.completeOrthogonalDecomposition().solve(Eigen::VectorXcd(here.value(equations)));
  }
  return std::nullopt;
}

namespace {

std::vector<std::complex<double>> random_point(int unknowns, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<std::complex<double>> x;
  for (int i = 0; i < unknowns; ++i) {
    const double re = normal(random), im = normal(random);
    x.emplace_back(re, im);
  }
  return x;
}

Eigen::Index rank_at(const QuadraticSystem& system, const std::vector<std::complex<double>>& x) {
  constexpr double tolerance = 1e-9;  // of rows of length 1
  Eigen::MatrixXcd jacobian = jacobian_at(system, x);
  jacobian.rowwise().normalize();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> factors(jacobian);
  factors.setThreshold(tolerance);
  return factors.rank();
}

}  // namespace

std::optional<std::vector<std::complex<double>>> random_zero(const QuadraticSystem& system,
                                                             const std::vector<int>& equations,
                                                             std::mt19937_64& random) {
  constexpr int most_starts = 20;
  const auto full = std::min(static_cast<Eigen::Index>(system.equations.size()),
                             static_cast<Eigen::Index>(system.unknowns));
  std::optional<std::vector<std::complex<double>>> best;
  Eigen::Index best_rank = -1;
  for (int start = 0; start < most_starts && best_rank < full; ++start) {
    auto zero = zero_near(system, equations, random_point(system.unknowns, random));
    if (!zero) continue;
    const Eigen::Index rank = rank_at(system, *zero);
    if (rank <= best_rank) continue;
    best_rank = rank;
    best = std::move(zero);
  }
  return best;
}

}  // namespace gcs
