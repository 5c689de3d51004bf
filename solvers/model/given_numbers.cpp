#include "solvers/model/given_numbers.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/numeric/balls.hpp"
#include "solvers/numeric/rounding.hpp"

namespace gcs {
namespace {

constexpr slong bits = 128;  ///< more than a double-double has

}  // namespace

ExactNumber given_square(const Scene& scene, int constraint) {
  const DistanceConstraint& c = scene.problem().constraints[static_cast<std::size_t>(constraint)];
  ExactNumber number = exactly(c.given.value);
  number.decimal = c.given.text;
  number.exponent = (c.is_squared ? -2 : -1) * scene.unit_exponent();
  number.is_squared = !c.is_squared;
  return number;
}

ExactNumber given_length(const Scene& scene, const Decimal& given) {
  if (given.value == 0) return {};
  ExactNumber number = exactly(given.value);
  number.decimal = given.text;
  number.exponent = -scene.unit_exponent();
  return number;
}

ExactNumber given_cosine(const Relation& relation, bool is_squared) {
  ExactNumber number = exactly(relation.given.value);
  number.decimal = relation.given.text;
  number.is_cosine_of_degrees = relation.form == Relation::Form::degrees;
  number.is_squared = is_squared;
  return number;
}

ExactNumber given_coordinate(const Scene& scene, int point, int axis) {
  const ProblemStatement& problem = scene.problem();
  const auto p = static_cast<std::size_t>(point);
  if (!scene.fixed_point(point)) return {};
  ExactNumber number = exactly((*problem.fixed_points[p])[axis]);
  if (!problem.fixed_texts.empty()) number.decimal = problem.fixed_texts[p][static_cast<std::size_t>(axis)];
  number.exponent = -scene.unit_exponent();
  return number;
}

Rational rational(const ExactNumber& number) {
  Rational result = number.decimal.empty() ? Rational::from_double(number.value.real())
                                           : Rational::from_decimal(number.decimal);
  result = result.times_power_of_two(number.exponent);
  if (number.is_squared) result = result * result;
  return number.is_negative ? Rational(-1) * result : result;
}

std::optional<Rational> fraction(const ExactNumber& number) {
  if (number.is_cosine_of_degrees || number.value.imag() != 0) return std::nullopt;
  const Rational whole = rational(number);
  if (number.divided_by_norm_of.empty()) return whole;
  Rational square;
  for (const ExactNumber& part : number.divided_by_norm_of) square = square + rational(part) * rational(part);
  const std::optional<Rational> norm = square.root();
  return norm ? std::optional(whole / *norm) : std::nullopt;
}

namespace {

bool has_fractions(const LinearForm& form) {
  return fraction(form.constant) && std::ranges::all_of(form.terms, [](const ScaledUnknown& term) {
           return fraction(term.coefficient).has_value();
         });
}

}  // namespace

bool has_fractions(const QuadraticEquation& equation) {
  return fraction(equation.given) && std::ranges::all_of(equation.products, [](const FormProduct& product) {
           return has_fractions(product.left) && has_fractions(product.right);
         });
}

DoubleDouble nearest_double_double(const ExactNumber& number) {
  Ball exact, high;
  const acb_ptr rest = exact;
  const auto nearest = [rest] { return arf_get_d(arb_midref(acb_realref(rest)), ARF_RND_NEAR); };
  enclose(exact, number, bits);
  const double hi = nearest();
  acb_set_d(high, hi);
  acb_sub(exact, exact, high, bits);
  return {hi, nearest()};
}

double coordinate_error(const Scene& scene, int point, int axis) {
  const auto position = scene.fixed_point(point);
  if (!position) return 0;
  const DoubleDouble exact = nearest_double_double(given_coordinate(scene, point, axis));
  return std::abs((exact - DoubleDouble{(*position)[axis], 0}).value()) * (1 + 4 * epsilon) +
         epsilon * std::abs(exact.lo);
}

}  // namespace gcs
