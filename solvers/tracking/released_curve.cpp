#include "solvers/tracking/released_curve.hpp"

#include <algorithm>
#include <utility>

namespace gcs {

ReleasedFamily ReleasedFamily::at_solution(const RealEquations& equations, const SignMasks& signs,
                                           Eigen::Index released, const Eigen::VectorXd& solution,
                                           int order) {
  Eigen::MatrixXd gradients(equations.count(), equations.unknowns);
  equations.jacobian(solution, gradients);
  return {equations, signs, released, gradients.row(released).norm(), with_time(solution, 1), order};
}

ReleasedFamily ReleasedFamily::at_figure(const RealEquations& equations, const SignMasks& signs,
                                         Eigen::Index released, const Eigen::VectorXd& x, int order) {
  const double scale = equations.given[released] - equations.sums(x)[released];
  return {equations, signs, released, scale, with_time(x, 0), order};
}

ReleasedFamily::ReleasedFamily(const RealEquations& equations, const SignMasks& signs, Eigen::Index released,
                               double scale, Eigen::VectorXd start, int order)
    : unknowns_(equations.unknowns),
      released_(released),
      given_(equations.given),
      signs_(signs),
      generators_(generators_of(signs)),
      scale_(scale),
      start_(std::move(start)) {
  const auto is_square = [](const RealEquations::Product& product) { return product.left == product.right; };
  std::vector<RealEquations::Product> products = equations.products;
  squares_ = std::stable_partition(products.begin(), products.end(), is_square) - products.begin();
  for (const RealEquations::Product& product : products) {
    equation_of_.push_back(product.equation);
    add_form(product.left);
  }
  for (Eigen::Index i = squares_; i < std::ssize(products); ++i)
    add_form(products[static_cast<std::size_t>(i)].right);
  forms_.setZero(std::ssize(constants_));
  series_.setZero(forms_.size(), order + 1);
}

void ReleasedFamily::add_form(const RealForm& form) {
  for (const auto& [unknown, coefficient] : form.terms) terms_.push_back({unknown, coefficient});
  ends_.push_back(terms_.size());
  constants_.push_back(form.constant);
}

/// What the forms change by when the unknowns do.
void ReleasedFamily::changes(const Eigen::Ref<const Eigen::VectorXd>& y,
                             Eigen::Ref<Eigen::VectorXd> forms) const {
  for (std::size_t form = 0; form + 1 < ends_.size(); ++form) {
    double sum = 0;
    for (std::size_t i = ends_[form]; i < ends_[form + 1]; ++i)
      sum += terms_[i].coefficient * y[terms_[i].unknown];
    forms[static_cast<Eigen::Index>(form)] = sum;
  }
}

void ReleasedFamily::evaluate(const Eigen::VectorXd& y) {
  changes(y, forms_);
  for (Eigen::Index form = 0; form < forms_.size(); ++form)
    forms_[form] += constants_[static_cast<std::size_t>(form)];
}

void ReleasedFamily::residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f) {
  evaluate(y);
  f = -given_;
  f[released_] -= scale_ * (y[unknowns_] - 1);
  for (Eigen::Index i = 0; i < std::ssize(equation_of_); ++i)
    f[equation_of_[static_cast<std::size_t>(i)]] += forms_[left(i)] * forms_[right(i)];
}

void ReleasedFamily::wide_residual(const Eigen::VectorXd& y, Eigen::Ref<Eigen::VectorXd> f) {
  std::vector<DoubleDouble> sums;
  for (const double given : given_) sums.push_back({-given});
  DoubleDouble& of_released = sums[static_cast<std::size_t>(released_)];
  of_released = of_released - DoubleDouble{scale_} * two_sum(y[unknowns_], -1.0);
  for (Eigen::Index i = 0; i < std::ssize(equation_of_); ++i) {
    DoubleDouble& sum = sums[static_cast<std::size_t>(equation_of_[static_cast<std::size_t>(i)])];
    sum = sum + wide_form(left(i), y) * wide_form(right(i), y);
  }
  for (std::size_t e = 0; e < sums.size(); ++e) f[static_cast<Eigen::Index>(e)] = sums[e].value();
}

DoubleDouble ReleasedFamily::wide_form(Eigen::Index form, const Eigen::VectorXd& y) const {
  const auto number = static_cast<std::size_t>(form);
  DoubleDouble sum{constants_[number]};
  for (std::size_t i = ends_[number]; i < ends_[number + 1]; ++i)
    sum = sum + two_product(terms_[i].coefficient, y[terms_[i].unknown]);
  return sum;
}

void ReleasedFamily::jacobian(const Eigen::VectorXd& y, Eigen::MatrixXd& matrix) {
  evaluate(y);
  matrix.topRows(given_.size()).setZero();
  const auto add = [&](Eigen::Index equation, Eigen::Index form, double factor) {
    const auto number = static_cast<std::size_t>(form);
    for (std::size_t i = ends_[number]; i < ends_[number + 1]; ++i)
      matrix(equation, terms_[i].unknown) += factor * terms_[i].coefficient;
  };
  for (Eigen::Index i = 0; i < std::ssize(equation_of_); ++i) {
    const Eigen::Index equation = equation_of_[static_cast<std::size_t>(i)];
    add(equation, left(i), forms_[right(i)]);
    add(equation, right(i), forms_[left(i)]);
  }
  matrix(released_, unknowns_) = -scale_;
}

void ReleasedFamily::set(int n, const Eigen::Ref<const Eigen::VectorXd>& coefficient) {
  changes(coefficient, series_.col(n));
}

void ReleasedFamily::known(int n, Eigen::Ref<Eigen::VectorXd> result) {
  convolution_.setZero(std::ssize(equation_of_));
  auto squares = convolution_.head(squares_), products = convolution_.tail(pairs());
  const auto of = [&](Eigen::Index first, Eigen::Index count, int order) {
    return series_.col(order).segment(first, count).array();
  };
  for (int i = 1; 2 * i < n; ++i) squares += 2 * of(0, squares_, i) * of(0, squares_, n - i);
  if (n % 2 == 0) squares += of(0, squares_, n / 2).square();
  for (int i = 1; i < n && pairs() > 0; ++i)
    products += of(squares_, pairs(), i) * of(squares_ + pairs(), pairs(), n - i);
  result.setZero();
  for (Eigen::Index i = 0; i < std::ssize(equation_of_); ++i)
    result[equation_of_[static_cast<std::size_t>(i)]] -= convolution_[i];
}

Eigen::VectorXd ReleasedFamily::signs_towards(const Eigen::VectorXd& y0, const Eigen::VectorXd& y) const {
  return gcs::signs_towards(signs_, generators_, y0, y);
}

}  // namespace gcs
