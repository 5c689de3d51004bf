#include "solvers/proven_paths/polynomial_length.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

LengthPath of_errors(const EnclosedLength& length) {
  return {length.sketch_error, length.target_error, length.bend_error, length.higher_errors};
}

/// Of a value or an expansion, relative to the sizes of its terms.
double few_roundings(int degree) { return (4 * degree + 16) * epsilon; }

/// Up to the order that both have.
Eigen::VectorXd truncated_product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  Eigen::VectorXd product = Eigen::VectorXd::Zero(a.size());
  for (Eigen::Index i = 0; i < a.size(); ++i) product.tail(a.size() - i) += a[i] * b.head(a.size() - i);
  return product;
}

/// Bounds on τ^k for |s| ≤ h, or on what it has beyond the order, and on the derivatives by s.
struct PowerBounds {
  double size = 1, speed = 0;     ///< of all of it
  Eigen::VectorXd terms;          ///< |coefficient n|·h^n up to the order
  double cut = 0, cut_speed = 0;  ///< of what is beyond
};

PowerBounds zeroth_power(int order) {
  PowerBounds one;
  one.terms = Eigen::VectorXd::Unit(order + 1, 0);
  return one;
}

/// (kept + cut)·τ: what is cut times all of τ, and the products of kept terms beyond the order.
PowerBounds times(const PowerBounds& power, const PowerBounds& tau, double h) {
  PowerBounds next;
  next.size = power.size * tau.size;
  next.speed = power.speed * tau.size + power.size * tau.speed;
  next.terms = truncated_product(power.terms, tau.terms);
  next.cut = power.cut * tau.size;
  next.cut_speed = power.cut_speed * tau.size + power.cut * tau.speed;
  const Eigen::Index order = tau.terms.size() - 1;
  for (Eigen::Index i = 0; i <= order; ++i)
    for (Eigen::Index j = order + 1 - i; j <= order; ++j) {
      const double term = power.terms[i] * tau.terms[j];
      next.cut += term;
      next.cut_speed += static_cast<double>(i + j) * term / h;
    }
  return next;
}

PowerBounds first_power(const Eigen::VectorXd& t, double h) {
  PowerBounds tau;
  tau.terms = Eigen::VectorXd::Zero(t.size());
  double power = 1;
  tau.size = 0;
  for (Eigen::Index n = 1; n < t.size(); ++n) {
    tau.speed += static_cast<double>(n) * std::abs(t[n]) * power;
    power *= h;
    tau.terms[n] = std::abs(t[n]) * power;
    tau.size += tau.terms[n];
  }
  return tau;
}

/// Σ |a_i| |b_j| h^(i+j) over i + j ≥ 3.
double product_rest(const Eigen::VectorXd& a, const Eigen::VectorXd& b, double h) {
  Eigen::VectorXd of_a = a.cwiseAbs(), of_b = b.cwiseAbs();
  double power = 1;
  for (Eigen::Index n = 0; n < a.size(); ++n, power *= h) {
    of_a[n] *= power;
    of_b[n] *= power;
  }
  double rest = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i)
    rest += of_a[i] * of_b.tail(of_b.size() - std::max<Eigen::Index>(0, 3 - i)).sum();
  return rest;
}

}  // namespace

void PolynomialLength::expand(const Eigen::VectorXd& t) {
  t_ = t;
  const LengthPath& path = length_.path;
  expansion_ = path.expansion(t[0]);
  errors_ = of_errors(length_).expansion_sizes(t[0]);
  const std::vector<double> sizes = path.expansion_sizes(t[0]);
  for (std::size_t k = 0; k < errors_.size(); ++k) errors_[k] += few_roundings(path.degree()) * sizes[k];
  value_ = slope_ = Eigen::VectorXd::Zero(order_ + 1);
  Eigen::VectorXd tau = t, power = Eigen::VectorXd::Unit(order_ + 1, 0);
  tau[0] = 0;
  for (std::size_t k = 0; k < expansion_.size(); ++k) {
    value_ += expansion_[k] * power;
    if (k + 1 < expansion_.size()) slope_ += static_cast<double>(k + 1) * expansion_[k + 1] * power;
    power = truncated_product(power, tau);
  }
}

Eigen::RowVector3d PolynomialLength::pull() const {
  if (length_.is_plain) return slope_.head<3>();
  return {value_[0] * slope_[0], value_[1] * slope_[0] + value_[0] * slope_[1],
          value_[2] * slope_[0] + value_[1] * slope_[1] + value_[0] * slope_[2]};
}

/// The coefficients of τ^k are off by (k − 1)(order + 2) roundings at most, relative to those of |τ|^k; sums over k add
/// a rounding each.
LengthBounds PolynomialLength::bound(double h) const {
  const int degree = length_.path.degree();
  const double rounding = (degree * (order_ + 4) + 16) * epsilon;
  const PowerBounds tau = first_power(t_, h);
  LengthBounds bounds;
  PowerBounds power = zeroth_power(order_), last;
  double near = 1;  // a bound on |t − t(0)| to the power of k − 2, for |t − t(s)| ≤ 1/2
  for (int k = 0; k <= degree; ++k) {
    const double size = std::abs(expansion_[static_cast<std::size_t>(k)]);
    const double error = errors_[static_cast<std::size_t>(k)], times_k = k;
    bounds.length_error += (error + rounding * size) * power.size + size * power.cut;
    bounds.length_speed_error += (error + rounding * size) * power.speed + size * power.cut_speed;
    if (k >= 1) {
      bounds.slope += times_k * (size + error) * last.size;
      bounds.slope_error += times_k * ((error + rounding * size) * last.size + size * last.cut);
    }
    if (k >= 2) {
      bounds.curvature += times_k * (times_k - 1) * (size + error) * near;
      near *= tau.size + 0.5;
    }
    last = std::move(power);
    power = times(last, tau, h);
  }
  const double time = std::abs(t_[0]) + tau.size + 1;
  bounds.value_error = of_errors(length_).expansion_sizes(time)[0] +
                       few_roundings(degree) * length_.path.expansion_sizes(time)[0];
  bounds.pull_rest =
      product_rest(length_.is_plain ? Eigen::VectorXd::Unit(order_ + 1, 0) : value_, slope_, h);
  for (double* bound : {&bounds.value_error, &bounds.length_error, &bounds.length_speed_error, &bounds.slope,
                        &bounds.slope_error, &bounds.curvature, &bounds.pull_rest})
    *bound *= round_up;
  return bounds;
}

}  // namespace gcs
