#include "solvers/tracking/real_equations.hpp"

#include <Eigen/LU>
#include <limits>

#include "solvers/model/given_numbers.hpp"

namespace gcs {
namespace {

double in_double(const ExactNumber& number) { return rounded_to_double(number).real(); }

RealForm real_form(const LinearForm& form) {
  RealForm result{{}, in_double(form.constant)};
  for (const ScaledUnknown& term : form.terms)
    result.terms.emplace_back(term.unknown, in_double(term.coefficient));
  return result;
}

}  // namespace

double RealForm::change(const Eigen::Ref<const Eigen::VectorXd>& x) const {
  double sum = 0;
  for (const auto& [unknown, coefficient] : terms) sum += coefficient * x[unknown];
  return sum;
}

Eigen::VectorXd RealEquations::sums(const Eigen::VectorXd& x) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(count());
  for (const Product& product : products)
    result[product.equation] += product.left.at(x) * product.right.at(x);
  return result;
}

DoubleDouble RealForm::wide_at(const Eigen::VectorXd& x) const {
  DoubleDouble sum{constant};
  for (const auto& [unknown, coefficient] : terms) sum = sum + two_product(coefficient, x[unknown]);
  return sum;
}

std::vector<DoubleDouble> RealEquations::wide_sums(const Eigen::VectorXd& x) const {
  std::vector<DoubleDouble> result(static_cast<std::size_t>(count()));
  for (const Product& product : products) {
    DoubleDouble& sum = result[static_cast<std::size_t>(product.equation)];
    sum = sum + product.left.wide_at(x) * product.right.wide_at(x);
  }
  return result;
}

WideEquations::Form::Form(const LinearForm& form) : constant(nearest_double_double(form.constant)) {
  for (const ScaledUnknown& term : form.terms)
    terms.emplace_back(static_cast<std::size_t>(term.unknown), nearest_double_double(term.coefficient));
}

DoubleDouble WideEquations::Form::at(const std::vector<DoubleDouble>& x) const {
  DoubleDouble sum = constant;
  for (const auto& [unknown, coefficient] : terms) sum = sum + coefficient * x[unknown];
  return sum;
}

WideEquations::WideEquations(const QuadraticSystem& system) : in_doubles_(real_equations(system)) {
  for (const QuadraticEquation& equation : system.equations) {
    for (const FormProduct& product : equation.products)
      products_.push_back({given_.size(), Form(product.left), Form(product.right)});
    given_.push_back(nearest_double_double(equation.given));
  }
}

std::vector<DoubleDouble> WideEquations::excess(const std::vector<DoubleDouble>& x) const {
  std::vector<DoubleDouble> result;
  for (const DoubleDouble& given : given_) result.push_back(-given);
  for (const Product& product : products_) {
    DoubleDouble& sum = result[product.equation];
    sum = sum + product.left.at(x) * product.right.at(x);
  }
  return result;
}

Eigen::VectorXd WideEquations::excess(const Eigen::VectorXd& x) const {
  std::vector<DoubleDouble> wide;
  for (const double value : x) wide.push_back({value, 0});
  const std::vector<DoubleDouble> sums = excess(wide);
  return Eigen::VectorXd::NullaryExpr(static_cast<Eigen::Index>(sums.size()), [&](Eigen::Index e) {
    return sums[static_cast<std::size_t>(e)].value();
  });
}

void RealEquations::jacobian(const Eigen::VectorXd& x, Eigen::MatrixXd& matrix) const {
  matrix.topLeftCorner(count(), unknowns).setZero();
  for (const Product& product : products) {
    const double left = product.left.at(x), right = product.right.at(x);
    for (const auto& [unknown, coefficient] : product.left.terms)
      matrix(product.equation, unknown) += coefficient * right;
    for (const auto& [unknown, coefficient] : product.right.terms)
      matrix(product.equation, unknown) += coefficient * left;
  }
}

Eigen::VectorXd real_parts(const std::vector<std::complex<double>>& values) {
  return Eigen::VectorXd::NullaryExpr(static_cast<Eigen::Index>(values.size()), [&](Eigen::Index i) {
    return values[static_cast<std::size_t>(i)].real();
  });
}

RealEquations real_equations(const QuadraticSystem& system) {
  RealEquations result;
  result.unknowns = system.unknowns;
  result.given.resize(static_cast<Eigen::Index>(system.equations.size()));
  for (Eigen::Index e = 0; e < result.count(); ++e) {
    const QuadraticEquation& equation = system.equations[static_cast<std::size_t>(e)];
    result.given[e] = in_double(equation.given);
    for (const FormProduct& product : equation.products)
      result.products.push_back({e, real_form(product.left), real_form(product.right)});
  }
  return result;
}

RealEquations without(Eigen::Index equation, const RealEquations& equations) {
  RealEquations result{equations.unknowns, {}, Eigen::VectorXd(equations.count() - 1)};
  result.given << equations.given.head(equation), equations.given.tail(equations.count() - 1 - equation);
  for (const RealEquations::Product& product : equations.products)
    if (product.equation != equation)
      result.products.push_back(
          {product.equation - (product.equation > equation ? 1 : 0), product.left, product.right});
  return result;
}

Refinement refine(const RealEquations& equations, double tolerance, Eigen::VectorXd& x) {
  constexpr int most_iterations = 20;
  Refinement result{false, 0, std::numeric_limits<double>::infinity()};
  Eigen::MatrixXd jacobian(equations.count(), equations.unknowns);
  while (result.iterations < most_iterations) {
    equations.jacobian(x, jacobian);
    const Eigen::VectorXd step = jacobian.partialPivLu().solve(equations.sums(x) - equations.given);
    const double last = result.last_correction;
    ++result.iterations;
    if (!step.allFinite()) return result;
    x -= step;
    result.last_correction = step.norm();
    if (!(result.last_correction < last / 2)) break;
  }
  result.converged = result.last_correction <= tolerance * (1 + x.cwiseAbs().maxCoeff());
  return result;
}

}  // namespace gcs
