#include "solvers/proven_paths/tube_series.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

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

Eigen::Index most_pairs(const PathEquations& equations) {
  Eigen::VectorXi pairs = Eigen::VectorXi::Zero(equations.count);
  for (const FormPair& pair : equations.pairs) ++pairs[pair.equation];
  return pairs.maxCoeff();
}

/// Whether pair p is the square of form p.
bool is_each_a_square(const PathEquations& equations) {
  if (equations.pairs.size() != equations.forms.size()) return false;
  for (std::size_t p = 0; p < equations.pairs.size(); ++p) {
    const auto form = static_cast<Eigen::Index>(p);
    if (equations.pairs[p].value != form || equations.pairs[p].moved != form) return false;
  }
  return true;
}

/// Of pairs whose equations follow each other.
std::vector<PairRun> runs_of(const PathEquations& equations) {
  std::vector<PairRun> runs;
  for (std::size_t p = 0; p < equations.pairs.size(); ++p) {
    const Eigen::Index e = equations.pairs[p].equation;
    if (runs.empty() || runs.back().equation + runs.back().length != e)
      runs.push_back({static_cast<Eigen::Index>(p), e, 0});
    ++runs.back().length;
  }
  return runs;
}

/// Roundings of sums beyond those of three products and a length.
double further_products(const PathEquations& equations) {
  return static_cast<double>(2 * std::max<Eigen::Index>(0, most_pairs(equations) - 3));
}

/// In a form and over an equation's products.
double most_summands(const PathEquations& equations) {
  std::size_t terms = 0;
  for (const EnclosedForm& form : equations.forms) terms = std::max(terms, form.terms.size() + 1);
  return static_cast<double>(terms) + static_cast<double>(most_pairs(equations));
}

}  // namespace

TubeSeries::TubeSeries(PathEquations equations, std::vector<EnclosedLength> lengths, int order)
    : equations_(std::move(equations)),
      lengths_(std::move(lengths)),
      order_(order),
      has_differences_(std::ranges::all_of(equations_.forms, &EnclosedForm::is_difference)),
      sum_rounding_((16 + further_products(equations_)) * epsilon),
      residual_rounding_((order + 8 + further_products(equations_)) * epsilon),
      form_rounding_(has_differences_ ? 0 : (16 + 2 * most_summands(equations_)) * epsilon),
      polynomials_(Eigen::MatrixXd::Zero(forms() + count(), order + 1)),
      runs_(runs_of(equations_)),
      are_squares_(is_each_a_square(equations_)),
      left_(static_cast<Eigen::Index>(equations_.pairs.size()) + count(), order + 1),
      right_(left_.rows(), order + 1),
      residuals_(count(), 2 * order + 1),
      pulls_(count(), 3) {
  for (const EnclosedForm& form : equations_.forms) {
    terms_.insert(terms_.end(), form.terms.begin(), form.terms.end());
    ends_.push_back(terms_.size());
  }
  for (int e = 0; e < count(); ++e)
    if (const EnclosedLength& length = lengths_[static_cast<std::size_t>(e)];
        length.is_plain || !length.path.higher.empty())
      polynomial_lengths_.emplace(e, PolynomialLength(length, order));
}

Eigen::MatrixXd TubeSeries::jacobian() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count(), coordinates());
  for (const auto& [e, value, moved] : equations_.pairs)
    for (const EnclosedForm::Term& term : terms(moved))
      matrix(e, term.coordinate) += coefficient(value, 0) * term.coefficient;
  matrix.col(coordinates() - 1) = -pulls_.col(0);
  return matrix;
}

Eigen::MatrixXd TubeSeries::jacobian_sizes() const {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count(), coordinates());
  for (const auto& [e, value, moved] : equations_.pairs)
    for (const EnclosedForm::Term& term : terms(moved))
      matrix(e, term.coordinate) += std::abs(coefficient(value, 0) * term.coefficient);
  matrix.col(coordinates() - 1) = pulls_.col(0).cwiseAbs();
  return matrix;
}

Eigen::VectorXd TubeSeries::equation_scales() const {
  if (has_differences_) return Eigen::VectorXd::Ones(count());
  TubeBounds at_centre;
  at_centre.size = polynomials_.col(0).cwiseAbs();
  bound_terms(at_centre);
  return at_centre.terms;
}

double TubeSeries::form_at(Eigen::Index form, const Eigen::VectorXd& y) const {
  const EnclosedForm& exact = equations_.forms[static_cast<std::size_t>(form)];
  double sum = exact.constant;
  for (const EnclosedForm::Term& term : terms(form)) sum += term.coefficient * y[term.coordinate];
  return sum;
}

double TubeSeries::form_error_at(Eigen::Index form, const Eigen::VectorXd& y,
                                 const Eigen::VectorXd& error) const {
  const EnclosedForm& exact = equations_.forms[static_cast<std::size_t>(form)];
  double sum = exact.constant_error + form_rounding_ * std::abs(exact.constant);
  for (const EnclosedForm::Term& term : terms(form))
    sum += std::abs(term.coefficient) * error[term.coordinate] +
           coefficient_error(term) * (std::abs(y[term.coordinate]) + error[term.coordinate]);
  return sum;
}

void TubeSeries::expand(const ArcSeries& c) {
  curve_ = c;
  set_forms();
  set_lengths();
  set_residuals();
}

void TubeSeries::set_forms() {
  polynomials_.topRows(forms()).setZero();
  const Eigen::MatrixXd& c = curve_.coefficients();
  for (Eigen::Index k = 0; k < forms(); ++k) {
    const EnclosedForm& form = equations_.forms[static_cast<std::size_t>(k)];
    polynomials_(k, 0) = form.constant;
    for (const EnclosedForm::Term& term : terms(k))
      polynomials_.row(k) += term.coefficient * c.row(term.coordinate);
  }
}

/// a(t) = a(t_0) + a'(t_0)·τ − bend·τ² with τ = t − t_0 as a polynomial in s, cut off at its order.
void TubeSeries::set_lengths() {
  auto a = polynomials_.bottomRows(count());
  const Eigen::VectorXd t = curve_.coefficients().row(coordinates() - 1);
  for (Eigen::Index e = 0; e < count(); ++e) {
    const LengthPath& path = lengths_[static_cast<std::size_t>(e)].path;
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
    a.row(e) = length.value();
    pulls_.row(e) = length.pull();
  }
}

/// V and D may be exchanged, so that half of their products are enough.
void TubeSeries::set_residuals() {
  if (!are_squares_) set_factors();
  const Eigen::MatrixXd &left = are_squares_ ? polynomials_ : left_,
                        &right = are_squares_ ? polynomials_ : right_;
  const Eigen::Index pairs = left.rows() - count();
  Eigen::ArrayXd products(left.rows());
  for (int n = 0; n <= 2 * order_; ++n) {
    products.setZero();
    for (int i = std::max(0, n - order_); 2 * i < n; ++i)
      products += left.col(i).array() * right.col(n - i).array();
    if (n % 2 == 0) products += 0.5 * (left.col(n / 2).array() * right.col(n / 2).array());
    for (const auto& [e, length] : polynomial_lengths_)
      if (length.is_plain()) products[pairs + e] = n <= order_ ? length.value()[n] : 0;
    auto f = residuals_.col(n);
    f = -products.tail(count());
    for (const PairRun& run : runs_)
      f.segment(run.equation, run.length) += products.segment(run.pair, run.length).matrix();
  }
}

void TubeSeries::set_factors() {
  const auto pairs = static_cast<Eigen::Index>(equations_.pairs.size());
  for (int n = 0; n <= order_; ++n)
    for (Eigen::Index p = 0; p < pairs; ++p) {
      const FormPair& pair = equations_.pairs[static_cast<std::size_t>(p)];
      left_(p, n) = polynomials_(pair.value, n);
      right_(p, n) = polynomials_(pair.moved, n);
    }
  left_.bottomRows(count()) = right_.bottomRows(count()) = polynomials_.bottomRows(count());
}

void TubeSeries::bound(double h, TubeBounds& bounds) const {
  const Eigen::VectorXd p = powers(h, order_ + 1);
  const auto sizes = polynomials_.cwiseAbs();
  bounds.h = h;
  bounds.size = sizes * p;
  bounds.speed = sizes * power_slopes(h, order_ + 1);
  bounds.rest = sizes.rightCols(order_ - 2) * p.tail(order_ - 2);
  bound_forms(bounds);
  bound_terms(bounds);
  bound_lengths(bounds);
  bound_residuals(bounds);
}

void TubeSeries::bound_forms(TubeBounds& bounds) const {
  bounds.form_error.setZero(forms());
  bounds.form_speed_error.setZero(forms());
  if (has_differences_) return;
  const auto sizes = curve_.coefficients().cwiseAbs();
  const Eigen::VectorXd size = sizes * powers(bounds.h, order_ + 1);
  const Eigen::VectorXd speed = sizes * power_slopes(bounds.h, order_ + 1);
  for (Eigen::Index k = 0; k < forms(); ++k) {
    const EnclosedForm& form = equations_.forms[static_cast<std::size_t>(k)];
    bounds.form_error[k] = form.constant_error + form_rounding_ * std::abs(form.constant);
    for (const EnclosedForm::Term& term : terms(k)) {
      bounds.form_error[k] += coefficient_error(term) * size[term.coordinate];
      bounds.form_speed_error[k] += coefficient_error(term) * speed[term.coordinate];
    }
  }
  bounds.form_error *= round_up;
  bounds.form_speed_error *= round_up;
}

void TubeSeries::bound_terms(TubeBounds& bounds) const {
  bounds.terms.setZero(count());
  for (const auto& [e, value, moved] : equations_.pairs)
    bounds.terms[e] += bounds.size[value] * bounds.size[moved];
  if (!has_differences_) add_least_terms(bounds);
  for (Eigen::Index e = 0; e < count(); ++e) {
    const double a = bounds.size[forms() + e];
    bounds.terms[e] += lengths_[static_cast<std::size_t>(e)].is_plain ? a : a * a;
  }
}

/// A form may vanish along all of a tube, but its equation still needs room: for what its coefficients make of a small
/// part of the scene's unit, in which lengths and unit vectors are near 1.
void TubeSeries::add_least_terms(TubeBounds& bounds) const {
  constexpr double least = 0x1p-10;
  for (const auto& [e, value, moved] : equations_.pairs)
    for (const EnclosedForm::Term& term : terms(moved))
      bounds.terms[e] += bounds.size[value] * std::abs(term.coefficient) * least;
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
    v->resize(count());
  const auto a = polynomials_.bottomRows(count()).cwiseAbs();
  const double rounding = (order_ + 32) * epsilon;
  for (Eigen::Index e = 0; e < count(); ++e) {
    const EnclosedLength& length = lengths_[static_cast<std::size_t>(e)];
    const double bend = std::abs(length.path.bend);
    const double sum = parameter_sum(length.path), error = parameter_error(length);
    const double slope = std::abs(length.path.slope(curve_.coefficient(0)[coordinates() - 1]));
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
  const Eigen::Index terms = residuals_.cols();
  const double rounding = residual_rounding_;
  const auto sizes = residuals_.cwiseAbs();
  bounds.residual = sizes * powers(bounds.h, terms);
  bounds.residual_speed = sizes * power_slopes(bounds.h, terms);
  const Eigen::ArrayXd &size = bounds.size, &speed = bounds.speed;
  for (const auto& [e, value, moved] : equations_.pairs) {
    bounds.residual[e] += rounding / 2 * (size[value] * size[moved]);
    bounds.residual_speed[e] +=
        (rounding * size[value] * speed[moved] + rounding * size[moved] * speed[value]) / 2;
  }
  if (!has_differences_) add_form_errors(bounds);
  for (Eigen::Index e = 0; e < count(); ++e) {
    const double a = size[forms() + e], a_speed = speed[forms() + e], error = bounds.length_error[e],
                 speed_error = bounds.length_speed_error[e];
    double &residual = bounds.residual[e], &residual_speed = bounds.residual_speed[e];
    if (lengths_[static_cast<std::size_t>(e)].is_plain) {
      residual = (residual + rounding * a + error) * round_up;
      residual_speed = (residual_speed + rounding * a_speed + speed_error) * round_up;
    } else {
      residual += rounding / 2 * (a * a);
      residual_speed += rounding * a * a_speed;
      residual = (residual + (a + error) * error) * round_up;
      residual_speed =
          (residual_speed + (a + error) * speed_error + (a_speed + speed_error) * error) * round_up;
    }
  }
}

void TubeSeries::add_form_errors(TubeBounds& bounds) const {
  for (const auto& [e, value, moved] : equations_.pairs) {
    const double v = bounds.size[value], d = bounds.size[moved], v_error = bounds.form_error[value],
                 d_error = bounds.form_error[moved];
    const double v_speed = bounds.speed[value], d_speed = bounds.speed[moved],
                 v_speed_error = bounds.form_speed_error[value],
                 d_speed_error = bounds.form_speed_error[moved];
    bounds.residual[e] += (v_error * (d + d_error) + v * d_error) / 2;
    bounds.residual_speed[e] += (v_speed_error * (d + d_error) + v_speed * d_error +
                                 v_error * (d_speed + d_speed_error) + v * d_speed_error) /
                                2;
  }
}

}  // namespace gcs
