#include "solvers/tangents/exact_spheres.hpp"

#include <flint/fmpq_mat.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "solvers/model/given_numbers.hpp"
#include "solvers/tangents/ternary_form.hpp"

namespace gcs {
namespace {

/// A homogeneous polynomial in three variables: its coefficients as in ternary_form.hpp.
struct RationalForm {
  int degree = 0;
  std::vector<Rational> coefficients;

  explicit RationalForm(int of_degree)
      : degree(of_degree), coefficients(static_cast<std::size_t>(monomial_count(of_degree))) {}

  Rational& operator[](int monomial) { return coefficients[static_cast<std::size_t>(monomial)]; }
  const Rational& operator[](int monomial) const { return coefficients[static_cast<std::size_t>(monomial)]; }
  int size() const { return static_cast<int>(coefficients.size()); }
};

int product_number(int a, int b) {
  const TernaryExponents e = exponents(a), f = exponents(b);
  return monomial_number(e.x + f.x, e.y + f.y);
}

RationalForm operator*(const RationalForm& p, const RationalForm& q) {
  RationalForm product(p.degree + q.degree);
  for (int i = 0; i < p.size(); ++i)
    for (int j = 0; j < q.size(); ++j) {
      Rational& target = product[product_number(i, j)];
      target = target + p[i] * q[j];
    }
  return product;
}

RationalForm operator*(const Rational& s, RationalForm p) {
  for (Rational& c : p.coefficients) c = s * c;
  return p;
}

/// Precondition: of the same degree.
RationalForm operator+(RationalForm p, const RationalForm& q) {
  for (int i = 0; i < p.size(); ++i) p[i] = p[i] + q[i];
  return p;
}

using FormVector3 = std::array<RationalForm, 3>;

/// u
const FormVector3& direction() {
  static const FormVector3 u = [] {
    FormVector3 variables{RationalForm(1), RationalForm(1), RationalForm(1)};
    variables[0][monomial_number(1, 0)] = 1;
    variables[1][monomial_number(0, 1)] = 1;
    variables[2][monomial_number(0, 0)] = 1;
    return variables;
  }();
  return u;
}

RationalForm dot(const FormVector3& a, const FormVector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

RationalForm dot(const RationalVector& a, const FormVector3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Σ forms_i vectors_i
template <std::size_t count>
FormVector3 combination(const std::array<RationalForm, count>& forms,
                        const std::array<RationalVector, count>& vectors) {
  const RationalForm zero(forms[0].degree);
  FormVector3 sum{zero, zero, zero};
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] = sum[axis] + vectors[i][axis] * forms[i];
  return sum;
}

/// The rank of the products of both forms with all monomials of the other's degree less one: full if and only
/// if they have no common factor.
bool have_common_factor(const RationalForm& p, const RationalForm& q) {
  const int with_p = monomial_count(q.degree - 1), with_q = monomial_count(p.degree - 1);
  fmpq_mat_t products, reduced;
  fmpq_mat_init(products, with_p + with_q, monomial_count(p.degree + q.degree - 1));
  fmpq_mat_init(reduced, fmpq_mat_nrows(products), fmpq_mat_ncols(products));
  for (int row = 0; row < with_p + with_q; ++row) {
    const RationalForm& form = row < with_p ? p : q;
    const int monomial = row < with_p ? row : row - with_p;
    for (int i = 0; i < form.size(); ++i)
      fmpq_set(fmpq_mat_entry(products, row, product_number(i, monomial)), form[i].raw());
  }
  const slong rank = fmpq_mat_rref(reduced, products);
  fmpq_mat_clear(products);
  fmpq_mat_clear(reduced);
  return rank < with_p + with_q;
}

/// By division by x² + y² + g².
bool is_multiple_of_isotropic(RationalForm p) {
  for (int x = p.degree; x >= 2; --x)
    for (int y = 0; x + y <= p.degree; ++y) {
      const Rational lead = std::exchange(p[monomial_number(x, y)], Rational());
      for (const int other : {monomial_number(x - 2, y + 2), monomial_number(x - 2, y)})
        p[other] = p[other] - lead;
    }
  return std::all_of(p.coefficients.begin(), p.coefficients.end(),
                     [](const Rational& c) { return c.is_zero(); });
}

/// The spheres about the first centre as origin.
class TangentForms {
 public:
  explicit TangentForms(const ExactSpheres& spheres) : square_(spheres[0].square) {
    for (std::size_t i = 0; i < 3; ++i) {
      centers_[i] = spheres[i + 1].center - spheres[0].center;
      const RationalForm along = dot(centers_[i], direction());
      const Rational constant = gcs::dot(centers_[i], centers_[i]) + square_ - spheres[i + 1].square;
      b_[i] = Rational(1) / Rational(2) * (constant * isotropic_ + Rational(-1) * (along * along));
    }
  }

  std::pair<RationalForm, RationalForm> forms() const {
    const Rational volume = gcs::dot(centers_[0], cross(centers_[1], centers_[2]));
    return volume.is_zero() ? coplanar() : spatial(volume);
  }

 private:
  /// P times the volume.
  std::pair<RationalForm, RationalForm> spatial(const Rational& volume) const {
    const FormVector3 p = combination<3>(
        b_,
        {cross(centers_[1], centers_[2]), cross(centers_[2], centers_[0]), cross(centers_[0], centers_[1])});
    return {dot(p, direction()),
            dot(p, p) + Rational(-1) * volume * volume * square_ * (isotropic_ * isotropic_)};
  }

  /// With q as in tangent_equations.hpp times n·n, for n = c_a × c_b of any length.
  std::pair<RationalForm, RationalForm> coplanar() const {
    std::size_t a = 0, b = 1, c = 2;
    if (is_zero(cross(centers_[a], centers_[b]))) std::swap(b, c);
    if (is_zero(cross(centers_[a], centers_[b]))) std::swap(a, c);
    const RationalVector n = cross(centers_[a], centers_[b]);
    const RationalVector across_a = cross(centers_[b], n), across_b = cross(n, centers_[a]);
    const Rational nn = gcs::dot(n, n);
    const FormVector3 q = combination<2>({b_[a], b_[b]}, {across_a, across_b});
    const RationalForm left = nn * b_[c] + Rational(-1) * dot(centers_[c], q);
    const RationalForm nu = dot(n, direction()), qu = dot(q, direction());
    const RationalForm rho =
        Rational(-1) * (dot(q, q) + Rational(-1) * square_ * nn * nn * (isotropic_ * isotropic_));
    return {left, nu * nu * rho + Rational(-1) * nn * (qu * qu)};
  }

  Rational square_;
  RationalForm isotropic_ = dot(direction(), direction());  ///< u·u
  std::array<RationalVector, 3> centers_;
  std::array<RationalForm, 3> b_{RationalForm(2), RationalForm(2), RationalForm(2)};
};

}  // namespace

ExactSpheres exact_spheres_of(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  ExactSpheres spheres;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const auto [a, b] = problem.constraints[i].between;
    const int point = problem.is_point(a) ? a : b;
    for (int axis = 0; axis < 3; ++axis)
      spheres[i].center[static_cast<std::size_t>(axis)] = rational(given_coordinate(scene, point, axis));
    spheres[i].square = rational(given_square(scene, static_cast<int>(i)));
  }
  return spheres;
}

bool have_infinitely_many_tangents(const ExactSpheres& spheres) {
  const auto [first, second] = TangentForms(spheres).forms();
  return have_common_factor(first, second) && !is_multiple_of_isotropic(first);
}

}  // namespace gcs
