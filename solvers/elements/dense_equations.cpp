#include "solvers/elements/dense_equations.hpp"

#include <Eigen/QR>
#include <algorithm>

#include "solvers/numeric/dense_factors.hpp"

namespace gcs {

DenseEquations::Form::Form(const LinearForm& form) : constant(rounded_to_double(form.constant)) {
  for (const ScaledUnknown& term : form.terms)
    terms.push_back({term.unknown, rounded_to_double(term.coefficient)});
}

std::complex<double> DenseEquations::Form::at(const std::vector<std::complex<double>>& x) const {
  std::complex<double> sum = constant;
  for (const auto& [unknown, coefficient] : terms) sum += coefficient * x[static_cast<std::size_t>(unknown)];
  return sum;
}

DenseEquations::DenseEquations(const QuadraticSystem& system) : unknowns_(system.unknowns) {
  for (const QuadraticEquation& equation : system.equations) {
    Row& row = rows_.emplace_back();
    row.given = rounded_to_double(equation.given);
    for (const FormProduct& product : equation.products)
      row.products.push_back({Form(product.left), Form(product.right)});
  }
}

EquationResiduals DenseEquations::residuals(const std::vector<std::complex<double>>& x) const {
  EquationResiduals result{Eigen::VectorXcd::Zero(count()), Eigen::VectorXd::Zero(count())};
  for (int e = 0; e < count(); ++e) {
    const Row& row = rows_[static_cast<std::size_t>(e)];
    result.value[e] = -row.given;
    result.size[e] = std::abs(result.value[e]);
    for (const Product& product : row.products) {
      const std::complex<double> term = product.left.at(x) * product.right.at(x);
      result.value[e] += term;
      result.size[e] += std::abs(term);
    }
  }
  return result;
}

Eigen::MatrixXcd DenseEquations::jacobian(const std::vector<std::complex<double>>& x) const {
  Eigen::MatrixXcd result = Eigen::MatrixXcd::Zero(count(), unknowns_);
  const auto add = [&](int row, const Form& form, std::complex<double> factor) {
    for (const auto& [unknown, coefficient] : form.terms) result(row, unknown) += coefficient * factor;
  };
  for (int e = 0; e < count(); ++e)
    for (const Product& product : rows_[static_cast<std::size_t>(e)].products) {
      add(e, product.left, product.right.at(x));
      add(e, product.right, product.left.at(x));
    }
  return result;
}

QuadraticSystem held_at(QuadraticSystem system, const std::vector<std::complex<double>>& x, int free) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> factors(DenseEquations(system).jacobian(x));
  const auto& order = factors.colsPermutation().indices();
  for (auto i = static_cast<Eigen::Index>(system.equations.size()) + free; i < system.unknowns; ++i) {
    const int unknown = order[i];
    system.equations.push_back({{{LinearForm{{{unknown}}, {}}, LinearForm{{}, exactly(1)}}},
                                exactly(x[static_cast<std::size_t>(unknown)])});
  }
  return system;
}

std::optional<std::vector<std::complex<double>>> zero_near(const DenseEquations& system,
                                                           const std::vector<int>& equations,
                                                           std::vector<std::complex<double>> x) {
  constexpr int most_iterations = 60;
  constexpr double settled = 1e-14, far = 1e3;
  Eigen::Map<Eigen::VectorXcd> point(x.data(), system.unknowns());
  for (int i = 0; i < most_iterations && point.allFinite(); ++i) {
    const EquationResiduals here = system.residuals(x);
    if ((here.value(equations).cwiseAbs().array() <= settled * (1 + here.size(equations).array())).all())
      return point.lpNorm<Eigen::Infinity>() <= far ? std::optional(x) : std::nullopt;
    point -=
        shortest_solution(Eigen::MatrixXcd(system.jacobian(x)(equations, Eigen::all)), here.value(equations));
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

Eigen::Index rank_at(const DenseEquations& system, const std::vector<std::complex<double>>& x) {
  constexpr double tolerance = 1e-9;  // of rows of length 1
  Eigen::MatrixXcd jacobian = system.jacobian(x);
  jacobian.rowwise().normalize();
  Eigen::ColPivHouseholderQR<Eigen::MatrixXcd> factors(jacobian);
  factors.setThreshold(tolerance);
  return factors.rank();
}

}  // namespace

std::optional<std::vector<std::complex<double>>> random_zero(const DenseEquations& system,
                                                             const std::vector<int>& equations,
                                                             std::mt19937_64& random) {
  constexpr int most_starts = 20;
  const auto full = static_cast<Eigen::Index>(std::min(system.count(), system.unknowns()));
  std::optional<std::vector<std::complex<double>>> best;
  Eigen::Index best_rank = -1;
  for (int start = 0; start < most_starts && best_rank < full; ++start) {
    auto zero = zero_near(system, equations, random_point(system.unknowns(), random));
    if (!zero) continue;
    const Eigen::Index rank = rank_at(system, *zero);
    if (rank <= best_rank) continue;
    best_rank = rank;
    best = std::move(zero);
  }
  return best;
}

}  // namespace gcs
