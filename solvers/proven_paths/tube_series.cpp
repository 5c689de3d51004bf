#include "solvers/proven_paths/tube_series.hpp"

#include <cmath>
#include <limits>

namespace gcs {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// 1, h, h², …
Eigen::VectorXd powers(double h, Eigen::Index count) {
  Eigen::VectorXd p(count);
  double power = 1;
  for (Eigen::Index n = 0; n < count; ++n, power *= h) p[n] = power;
  return p;
}

/// The derivatives of these powers.
Eigen::VectorXd power_slopes(double h, Eigen::Index count) {
  Eigen::VectorXd p = Eigen::VectorXd::Zero(count);
  double power = 1;
  for (Eigen::Index n = 1; n < count; ++n, power *= h) p[n] = static_cast<double>(n) * power;
  return p;
}

double parameter_sum(const LengthPath& path) {
  return std::abs(path.at_sketch) + std::abs(path.at_target) + std::abs(path.bend);
}

double parameter_error(const EnclosedLength& length) {
  return length.sketch_error + length.target_error + length.bend_error;
}

}  // namespace

TubeSeries::TubeSeries(const DistanceSystem& system, std::vector<EnclosedLength> lengths, int order)
    : system_(system),
      lengths_(std::move(lengths)),
      order_(order),
      polynomials_(Eigen::MatrixXd::Zero((axes() + 1) * edges(), order + 1)),
      residuals_(edges(), 2 * order + 1),
      pulls_(edges(), 3) {
  for (int e = 0; e < edges(); ++e)
    if (const EnclosedLength& length = lengths_[e]; !length.path.higher.empty())
      polynomial_lengths_.emplace(e, PolynomialLength(length, order));
}

std::array<int, 2> TubeSeries::ends(int axis, int edge) const {
  const auto [a, b] = system_.edges()[edge];
  const int i = system_.unknown(a, axis), j = system_.unknown(b, axis);
  return {i >= 0 ? i : coordinates(), j >= 0 ? j : coordinates()};
}

Eigen::MatrixXd TubeSeries::jacobian() const {
  Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(edges(), coordinates() + 1);
  for (int axis = 0; axis < axes(); ++axis)
    for (int e = 0; e < edges(); ++e) {
      const auto [i, j] = ends(axis, e);
      padded(e, i) = coefficient(axis, e, 0);
      padded(e, j) = -coefficient(axis, e, 0);
    }
  padded.col(coordinates() - 1) = -pulls_.col(0);
  return padded.leftCols(coordinates());
}

void TubeSeries::expand(const ArcSeries& c) {
  curve_ = c;
  set_differences();
  set_lengths();
  set_residuals();
}

void TubeSeries::set_differences() {
  Eigen::VectorXd padded = Eigen::VectorXd::Zero(coordinates() + 1);
  for (int n = 0; n <= order_; ++n) {
    padded.head(coordinates()) = curve_.coefficient(n);
    for (int axis = 0; axis < axes(); ++axis)
      for (int e = 0; e < edges(); ++e) {
        const auto [i, j] = ends(axis, e);
        polynomials_(axis * edges() + e, n) = padded[i] - padded[j];
      }
  }
}

/// a(t) = a(t_0) + a'(t_0)·τ − bend·τ² with τ = t − t_0 as a polynomial in s, cut off at its order.
void TubeSeries::set_lengths() {
  auto a = polynomials_.bottomRows(edges());
  const Eigen::VectorXd t = curve_.coefficients().row(coordinates() - 1);
  for (int e = 0; e < edges(); ++e) {
    const LengthPath& path = lengths_[e].path;
    const double slope = path.slope(t[0]), bend = path.bend;
    a.row(e) = slope * t.transpose();
    a(e, 0) = path.value(t[0]);
    if (bend != 0)
      for (int n = 2; n <= order_; ++n)
        for (int i = 1; i < n; ++i) a(e, n) -= bend * t[i] * t[n - i];
    pulls_(e, 0) = a(e, 0) * slope;
    pulls_(e, 1) = a(e, 1) * slope - 2 * bend * t[1] * a(e, 0);
    pulls_(e, 2) = a(e, 2) * slope - 2 * bend * (t[1] * a(e, 1) + t[2] * a(e, 0));
  }
  for (auto& [e, length] : polynomial_lengths_) {
    length.expand(t);
    const Eigen::VectorXd &value = length.value(), &slope = length.slope();
    a.row(e) = value;
    pulls_.row(e) << value[0] * slope[0], value[1] * slope[0] + value[0] * slope[1],
        value[2] * slope[0] + value[1] * slope[1] + value[0] * slope[2];
  }
}

void TubeSeries::set_residuals() {
  const Eigen::Index m = edges();
  Eigen::ArrayXd sum(polynomials_.rows());
  for (int n = 0; n <= 2 * order_; ++n) {
    sum.setZero();
    for (int i = std::max(0, n - order_); 2 * i < n; ++i)
      sum += polynomials_.col(i).array() * polynomials_.col(n - i).array();
    if (n % 2 == 0) sum += 0.5 * polynomials_.col(n / 2).array().square();
    auto f = residuals_.col(n);
    f = sum.head(m) - sum.tail(m);
    for (int axis = 1; axis < axes(); ++axis) f += sum.segment(axis * m, m).matrix();
  }
}

void TubeSeries::bound(double h, TubeBounds& bounds) const {
  const Eigen::VectorXd p = powers(h, order_ + 1);
  const auto sizes = polynomials_.cwiseAbs();
  bounds.h = h;
  bounds.size = sizes * p;
  bounds.speed = sizes * power_slopes(h, order_ + 1);
  bounds.rest = sizes.rightCols(order_ - 2) * p.tail(order_ - 2);
  bound_lengths(bounds);
  bound_residuals(bounds);
}

/// The parameters' errors and rounding are taken for |t| up to 1 beyond its bound on c.
void TubeSeries::bound_lengths(TubeBounds& bounds) const {
  const Eigen::VectorXd t = curve_.coefficients().row(coordinates() - 1).cwiseAbs();
  const Eigen::VectorXd terms = t.cwiseProduct(powers(bounds.h, order_ + 1));
  const double moved = terms.tail(order_).sum();
  bounds.time = t[0] + moved;
  bounds.time_speed = t.dot(power_slopes(bounds.h, order_ + 1));
  double cut = 0, cut_speed = 0;  // of τ², beyond the order
  for (int i = 1; i <= order_; ++i)
    for (int j = order_ + 1 - i; j <= order_; ++j) {
      cut += terms[i] * terms[j];
      cut_speed += (i + j) * terms[i] * terms[j] / bounds.h;
    }
  const double reach = 2 + bounds.time;
  for (Eigen::ArrayXd* v : {&bounds.value_error, &bounds.length_error, &bounds.length_speed_error,
                            &bounds.slope, &bounds.slope_error, &bounds.curvature, &bounds.pull_rest})
    v->resize(edges());
  const auto a = polynomials_.bottomRows(edges()).cwiseAbs();
  const double rounding = (order_ + 32) * epsilon;
  for (int e = 0; e < edges(); ++e) {
    const double bend = std::abs(lengths_[e].path.bend);
    const double sum = parameter_sum(lengths_[e].path), error = parameter_error(lengths_[e]);
    const double slope = std::abs(lengths_[e].path.slope(curve_.coefficient(0)[coordinates() - 1]));
    bounds.value_error[e] = (error + 8 * epsilon * sum) * reach * reach;
    bounds.length_error[e] = (error + rounding * sum) * reach * reach + bend * cut;
    bounds.slope_error[e] = 2 * (error + rounding * sum) * reach;
    bounds.length_speed_error[e] = 2 * bounds.slope_error[e] * bounds.time_speed + bend * cut_speed;
    bounds.slope[e] = slope + 2 * bend * moved + bounds.slope_error[e];
    bounds.curvature[e] = 2 * bend;
    const auto tail = [&](int n) {
      double value = 0, power = std::pow(bounds.h, n);
      for (; n <= order_; ++n, power *= bounds.h) value += a(e, n) * power;
      return value;
    };
    bounds.pull_rest[e] = slope * tail(3);
    if (bend != 0)
      bounds.pull_rest[e] +=
          2 * bend * (terms[1] * tail(2) + terms[2] * tail(1) + terms.tail(order_ - 2).sum() * tail(0));
  }
  bound_polynomial_lengths(bounds);
}

void TubeSeries::bound_polynomial_lengths(TubeBounds& bounds) const {
  for (const auto& [e, length] : polynomial_lengths_) {
    const LengthBounds of = length.bound(bounds.h);
    bounds.value_error[e] = of.value_error;
    bounds.length_error[e] = of.length_error;
    bounds.length_speed_error[e] = of.length_speed_error;
    bounds.slope[e] = of.slope;
    bounds.slope_error[e] = of.slope_error;
    bounds.curvature[e] = of.curvature;
    bounds.pull_rest[e] = of.pull_rest;
  }
}

void TubeSeries::bound_residuals(TubeBounds& bounds) const {
  const Eigen::Index m = edges(), terms = residuals_.cols();
  const double rounding = (order_ + 8) * epsilon;
  const auto sizes = residuals_.cwiseAbs();
  bounds.residual = sizes * powers(bounds.h, terms);
  bounds.residual_speed = sizes * power_slopes(bounds.h, terms);
  for (int axis = 0; axis <= axes(); ++axis) {
    const auto size = bounds.size.segment(axis * m, m), speed = bounds.speed.segment(axis * m, m);
    bounds.residual += rounding / 2 * size.square();
    bounds.residual_speed += rounding * size * speed;
  }
  const Eigen::ArrayXd length = bounds.size.tail(m) + bounds.length_error;
  bounds.residual = (bounds.residual + length * bounds.length_error) * round_up;
  bounds.residual_speed = (bounds.residual_speed + length * bounds.length_speed_error +
                           (bounds.speed.tail(m) + bounds.length_speed_error) * bounds.length_error) *
                          round_up;
}

}  // namespace gcs
