#include "solvers/model/ball_krawczyk.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

bool is_real(const BallMatrix& x) {
  for (slong i = 0; i < x.rows(); ++i)
    if (!arb_is_zero(acb_imagref(x(i, 0)))) return false;
  return true;
}

/// The largest |x_i|.
double size_of(const BallMatrix& x) {
  double size = 0;
  for (slong i = 0; i < x.rows(); ++i) size = std::max(size, magnitude(x(i, 0)));
  return size;
}

void drop_radii(BallMatrix& x) { acb_mat_get_mid(x.get(), x.get()); }

bool lies_inside(arb_srcptr inner, arb_srcptr outer) { return arb_contains_interior(outer, inner) != 0; }

/// `in_reals`: all imaginary parts are 0.
bool lies_inside(const BallMatrix& inner, const BallMatrix& outer, bool in_reals) {
  for (slong i = 0; i < inner.rows(); ++i) {
    if (!lies_inside(acb_realref(inner(i, 0)), acb_realref(outer(i, 0)))) return false;
    if (!in_reals && !lies_inside(acb_imagref(inner(i, 0)), acb_imagref(outer(i, 0)))) return false;
  }
  return true;
}

}  // namespace

BallKrawczyk::BallKrawczyk(const QuadraticSystem& system, slong bits)
    : unknowns_(system.unknowns), bits_(bits) {
  for (const QuadraticEquation& exact : system.equations) {
    Equation equation{{}, number(exact.given)};
    for (const FormProduct& product : exact.products)
      equation.products.push_back({form(product.left), form(product.right)});
    equations_.push_back(std::move(equation));
  }
}

std::size_t BallKrawczyk::number(const ExactNumber& exact) {
  numbers_.emplace_back(1, 1);
  enclose(numbers_.back()(0, 0), exact, bits_);
  is_real_ = is_real_ && exact.value.imag() == 0;
  return numbers_.size() - 1;
}

BallKrawczyk::Form BallKrawczyk::form(const LinearForm& exact) {
  Form form{{}, number(exact.constant)};
  for (const ScaledUnknown& term : exact.terms)
    form.terms.push_back({term.unknown, number(term.coefficient)});
  return form;
}

BallMatrix BallKrawczyk::vector(const std::vector<std::complex<double>>& x) {
  BallMatrix result(static_cast<slong>(x.size()), 1);
  for (std::size_t i = 0; i < x.size(); ++i)
    acb_set_d_d(result(static_cast<slong>(i), 0), x[i].real(), x[i].imag());
  return result;
}

void BallKrawczyk::evaluate(const Form& form, const BallMatrix& x, acb_ptr value) const {
  acb_set(value, at(form.constant));
  for (const auto& [unknown, coefficient] : form.terms)
    acb_addmul(value, at(coefficient), x(unknown, 0), bits_);
}

BallMatrix BallKrawczyk::value(const BallMatrix& x) const {
  BallMatrix result(unknowns_, 1);
  Ball left, right;
  for (std::size_t e = 0; e < equations_.size(); ++e) {
    acb_ptr sum = result(static_cast<slong>(e), 0);
    acb_neg(sum, at(equations_[e].given));
    for (const Product& product : equations_[e].products) {
      evaluate(product.left, x, left);
      evaluate(product.right, x, right);
      acb_addmul(sum, left, right, bits_);
    }
  }
  return result;
}

void BallKrawczyk::add_gradient(const Form& form, acb_srcptr factor, slong row, BallMatrix& jacobian) const {
  for (const auto& [unknown, coefficient] : form.terms)
    acb_addmul(jacobian(row, unknown), at(coefficient), factor, bits_);
}

BallMatrix BallKrawczyk::jacobian(const BallMatrix& x) const {
  BallMatrix result(unknowns_, unknowns_);
  Ball left, right;
  for (std::size_t e = 0; e < equations_.size(); ++e)
    for (const Product& product : equations_[e].products) {
      evaluate(product.left, x, left);
      evaluate(product.right, x, right);
      add_gradient(product.left, right, static_cast<slong>(e), result);
      add_gradient(product.right, left, static_cast<slong>(e), result);
    }
  return result;
}

double BallKrawczyk::bend(const BallMatrix& inverse) const {
  std::vector<double> moves;  // of a row of the Jacobian
  for (const Equation& equation : equations_) {
    double move = 0;
    for (const auto& [left, right] : equation.products)
      for (const Term& a : left.terms)
        for (const Term& b : right.terms)
          move += 2 * magnitude(at(a.coefficient)) * magnitude(at(b.coefficient));
    moves.push_back(move);
  }
  double largest = 0;
  for (slong i = 0; i < inverse.rows(); ++i) {
    double sum = 0;
    for (slong e = 0; e < inverse.columns(); ++e)
      sum += magnitude(inverse(i, e)) * moves[static_cast<std::size_t>(e)];
    largest = std::max(largest, sum);
  }
  return largest;
}

BallKrawczyk::Newton BallKrawczyk::refined(const BallMatrix& start) const {
  constexpr int most_steps = 40;
  Newton newton{start};
  BallMatrix correction(unknowns_, 1);
  const double small = std::ldexp(1.0, static_cast<int>(-bits_ / 2));
  for (int step = 0; step < most_steps && !newton.converged; ++step) {
    BallMatrix& x = newton.x;
    newton.is_singular = !acb_mat_approx_solve(correction.get(), jacobian(x).get(), value(x).get(), bits_);
    if (newton.is_singular) break;
    drop_radii(correction);
    acb_mat_sub(x.get(), x.get(), correction.get(), bits_);
    drop_radii(x);
    newton.correction = size_of(correction) / size_of(x);
    if (!std::isfinite(newton.correction)) break;
    // Quadratic convergence: what this step has left is of the size of its square.
    newton.converged = newton.correction <= small;
  }
  return newton;
}

BallMatrix BallKrawczyk::box_around(const BallMatrix& x, double radius) const {
  BallMatrix box = x;
  arb_t width;
  arb_init(width);
  arb_set_d(width, radius);
  const bool in_reals = is_real_ && is_real(x);
  for (slong i = 0; i < box.rows(); ++i) {
    arb_add_error(acb_realref(box(i, 0)), width);
    if (!in_reals) arb_add_error(acb_imagref(box(i, 0)), width);
  }
  arb_clear(width);
  return box;
}

BallMatrix BallKrawczyk::image(const BallMatrix& x, const BallMatrix& correction, const BallMatrix& inverse,
                               const BallMatrix& box) const {
  BallMatrix defect(unknowns_, unknowns_), offset(unknowns_, 1), result(unknowns_, 1);
  acb_mat_mul(defect.get(), inverse.get(), jacobian(box).get(), bits_);
  acb_mat_neg(defect.get(), defect.get());
  for (slong i = 0; i < unknowns_; ++i) acb_add_si(defect(i, i), defect(i, i), 1, bits_);
  acb_mat_sub(offset.get(), box.get(), x.get(), bits_);
  acb_mat_mul(result.get(), defect.get(), offset.get(), bits_);
  acb_mat_sub(result.get(), result.get(), correction.get(), bits_);
  acb_mat_add(result.get(), result.get(), x.get(), bits_);
  return result;
}

std::optional<BallKrawczyk::Proof> BallKrawczyk::prove(const BallMatrix& x) const {
  BallMatrix inverse(unknowns_, unknowns_);
  if (!acb_mat_approx_inv(inverse.get(), jacobian(x).get(), bits_)) return std::nullopt;
  drop_radii(inverse);
  // A test in exact arithmetic bears 1/bend; products of complex rectangles are up to 4 times as large as
  // those of discs, and half of the rest is left for the rounding.
  const double radius = 1 / (8 * bend(inverse));
  if (!(radius > 0)) return std::nullopt;
  const BallMatrix box = box_around(x, radius);
  const bool in_reals = is_real_ && is_real(x);
  BallMatrix correction(unknowns_, 1);
  acb_mat_mul(correction.get(), inverse.get(), value(x).get(), bits_);
  Proof proof{image(x, correction, inverse, box), 0};
  if (!lies_inside(proof.solution, box, in_reals)) return std::nullopt;

  // Around a few of Newton's corrections there is one too, and so the same, enclosed as tightly as rounding allows.
  const double near = std::max(4 * size_of(correction), std::ldexp(radius, static_cast<int>(-bits_)));
  const BallMatrix near_box = box_around(x, near), near_image = image(x, correction, inverse, near_box);
  if (2 * near < radius && lies_inside(near_image, near_box, in_reals)) proof.solution = near_image;

  BallMatrix moved(unknowns_, 1);
  acb_mat_sub(moved.get(), proof.solution.get(), x.get(), bits_);
  proof.unique = (radius - size_of(moved)) * (1 - epsilon);
  return proof;
}

Enclosure enclosure_of(const BallKrawczyk::Proof& proof) {
  Enclosure enclosure;
  enclosure.unique = proof.unique;
  Ball rest;
  for (slong i = 0; i < proof.solution.rows(); ++i) {
    const acb_srcptr ball = proof.solution(i, 0);
    const std::complex<double> mid = rounded_midpoint(ball);
    acb_set_d_d(rest, mid.real(), mid.imag());
    acb_sub(rest, ball, rest, 64);
    acb_srcptr difference = rest;
    Ball part;
    acb_set_arb(part, acb_realref(difference));
    const double re = magnitude(part);
    acb_set_arb(part, acb_imagref(difference));
    enclosure.mid.push_back(mid);
    enclosure.radius.emplace_back(re, magnitude(part));
    // Uniqueness is about the ball's middle, which rounding has moved.
    enclosure.unique = std::min(enclosure.unique, proof.unique - 2 * epsilon * std::abs(mid));
  }
  return enclosure;
}

}  // namespace gcs
