#pragma once
/// Homogeneous polynomials in three variables (x, y, g), as the coefficients of their monomials.
///
/// The monomial x^i y^j g^k has the number s(s + 1)/2 + j with s = i + j, whatever k is: what is multiplied
/// by g keeps its numbers.

#include <Eigen/Core>
#include <array>

namespace gcs {

constexpr int monomial_count(int degree) { return (degree + 1) * (degree + 2) / 2; }
constexpr int monomial_number(int i, int j) { return (i + j) * (i + j + 1) / 2 + j; }

/// Exponents of x and y.
struct TernaryExponents {
  int x = 0;
  int y = 0;
};

constexpr TernaryExponents exponents(int number) {
  int s = 0;
  while (monomial_count(s) <= number) ++s;
  const int y = number - s * (s + 1) / 2;
  return {s - y, y};
}

template <int degree>
using Form = Eigen::Matrix<double, monomial_count(degree), 1>;

using TernaryLinearForm = Form<1>;
using QuadraticForm = Form<2>;
using CubicForm = Form<3>;
using QuarticForm = Form<4>;

/// Adds factor · form · monomial to `target`, whose degree is at least that of the product.
template <class Target, class Source>
void add_product(const Source& form, int monomial, double factor, Target&& target) {
  const TernaryExponents by = exponents(monomial);
  for (int i = 0; i < form.size(); ++i) {
    const TernaryExponents e = exponents(i);
    target[monomial_number(e.x + by.x, e.y + by.y)] += factor * form[i];
  }
}

template <int a, int b>
Form<a + b> form_product(const Form<a>& p, const Form<b>& q) {
  Form<a + b> product = Form<a + b>::Zero();
  for (int i = 0; i < q.size(); ++i) add_product(p, i, q[i], product);
  return product;
}

/// The value at (x, y, g).
template <int degree, class Scalar>
Scalar form_value(const Form<degree>& form, const Eigen::Matrix<Scalar, 3, 1>& at) {
  Scalar value(0);
  Scalar g_power(1);
  for (int s = degree; s >= 0; --s) {
    Scalar level(0);
    Scalar y_power(1);
    for (int j = 0; j <= s; ++j) {
      level = level * at[0] + form[monomial_number(s - j, j)] * y_power;
      y_power *= at[1];
    }
    value += level * g_power;
    g_power *= at[2];
  }
  return value;
}

/// The derivatives by x, y and g.
template <int degree, class Scalar>
Eigen::Matrix<Scalar, 1, 3> form_gradient(const Form<degree>& form, const Eigen::Matrix<Scalar, 3, 1>& at) {
  std::array<Form<degree - 1>, 3> derivative;
  for (auto& d : derivative) d.setZero();
  for (int number = 0; number < form.size(); ++number) {
    const auto [i, j] = exponents(number);
    const int k = degree - i - j;
    if (i > 0) derivative[0][monomial_number(i - 1, j)] += i * form[number];
    if (j > 0) derivative[1][monomial_number(i, j - 1)] += j * form[number];
    if (k > 0) derivative[2][number] += k * form[number];
  }
  return {form_value<degree - 1>(derivative[0], at), form_value<degree - 1>(derivative[1], at),
          form_value<degree - 1>(derivative[2], at)};
}

}  // namespace gcs
