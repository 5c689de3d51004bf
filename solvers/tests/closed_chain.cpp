#include "solvers/tests/closed_chain.hpp"

#include <algorithm>
#include <array>

#include "solvers/numeric/prime_field.hpp"

namespace gcs::samples {
namespace {

/// A scalar and a vector, and the same times ε.
struct DualQuaternion {
  Residue scalar;
  Residue3 vector{};
  Residue dual_scalar{};
  Residue3 dual_vector{};
};

/// Coefficients of the monomials of degree (d, d, d) in three pairs of variables, u_i^a to the power a = 0 …
/// d at the i-th digit to the base d + 1.
using Form = ResidueVector;

DualQuaternion operator*(const DualQuaternion& a, const DualQuaternion& b) {
  const auto scalar = [](Residue s, const Residue3& v, Residue t, const Residue3& w) {
    return s * t - dot(v, w);
  };
  const auto vector = [](Residue s, const Residue3& v, Residue t, const Residue3& w) {
    return s * w + t * v + cross(v, w);
  };
  return {scalar(a.scalar, a.vector, b.scalar, b.vector), vector(a.scalar, a.vector, b.scalar, b.vector),
          scalar(a.scalar, a.vector, b.dual_scalar, b.dual_vector) +
              scalar(a.dual_scalar, a.dual_vector, b.scalar, b.vector),
          vector(a.scalar, a.vector, b.dual_scalar, b.dual_vector) +
              vector(a.dual_scalar, a.dual_vector, b.scalar, b.vector)};
}

/// d + ε a×d for the line through a and b, d = b − a.
DualQuaternion line_through(const Residue3& a, const Residue3& b) { return {{}, b - a, {}, cross(a, b - a)}; }

Residue3 random_point(std::mt19937_64& random) {
  return {Residue::random(random), Residue::random(random), Residue::random(random)};
}

std::vector<DualQuaternion> random_hinges(const std::vector<bool>& meets, std::mt19937_64& random) {
  std::vector<Residue3> starts;
  for (std::size_t i = 0; i < meets.size(); ++i) starts.push_back(random_point(random));
  std::vector<DualQuaternion> hinges;
  for (std::size_t i = 0; i < meets.size(); ++i)
    hinges.push_back(
        line_through(starts[i], meets[i] ? starts[(i + 1) % starts.size()] : random_point(random)));
  return hinges;
}

/// The coefficients of (x₁ + y₁h₁)(x₂ + y₂h₂)(x₃ + y₃h₃), with y_i where the bit is set: bit 0 for i = 1.
ResidueMatrix product_of_rotations(const DualQuaternion& h1, const DualQuaternion& h2,
                                   const DualQuaternion& h3) {
  const DualQuaternion one{Residue(1)};
  ResidueMatrix coefficients;
  for (int bits = 0; bits < 8; ++bits) {
    const DualQuaternion q = (bits & 1 ? h1 : one) * (bits & 2 ? h2 : one) * (bits & 4 ? h3 : one);
    ResidueVector& row =
        coefficients.emplace_back(ResidueVector{q.scalar, q.vector[0], q.vector[1], q.vector[2]});
    row.insert(row.end(), {q.dual_scalar, q.dual_vector[0], q.dual_vector[1], q.dual_vector[2]});
  }
  return coefficients;
}

/// The coordinates of f(u) in the basis of the eight coefficients of g, as forms. Precondition: it is one.
std::vector<Form> coordinates(const ResidueMatrix& f, const ResidueMatrix& g) {
  ResidueMatrix both = g;
  both.insert(both.end(), f.begin(), f.end());
  const ResidueMatrix relations = null_space(transposed(both, 8), 16);  // Σ z_c g_c + f_m = 0
  std::vector<Form> forms(8, Form(8));
  for (std::size_t m = 0; m < 8; ++m)
    for (std::size_t c = 0; c < 8; ++c) forms[c][m] = -relations[m][c];
  return forms;
}

/// Number of the monomial that is the product of those numbered i, of degree d, and j, of degree e.
std::size_t monomial_product(std::size_t i, std::size_t d, std::size_t j, std::size_t e) {
  std::size_t number = 0;
  for (std::size_t place = 1, digit = 0; digit < 3; ++digit, place *= d + e + 1) {
    number += place * (i % (d + 1) + j % (e + 1));
    i /= d + 1;
    j /= e + 1;
  }
  return number;
}

std::size_t monomials(std::size_t degree) { return (degree + 1) * (degree + 1) * (degree + 1); }

Form product(const Form& a, std::size_t d, const Form& b, std::size_t e) {
  Form result(monomials(d + e));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) result[monomial_product(i, d, j, e)] += a[i] * b[j];
  return result;
}

/// The 2×2 minors of the 2×2×2 tensor z, flattened in three ways.
std::vector<Form> minors(const std::vector<Form>& z) {
  std::vector<Form> forms;
  for (const std::size_t axis : {1, 2, 4}) {
    std::vector<std::size_t> rest;
    for (std::size_t c = 0; c < 8; ++c)
      if ((c & axis) == 0) rest.push_back(c);
    for (std::size_t s = 0; s < 4; ++s)
      for (std::size_t t = 0; t < s; ++t) {
        Form& form = forms.emplace_back(product(z[rest[s]], 1, z[rest[t] + axis], 1));
        const Form other = product(z[rest[t]], 1, z[rest[s] + axis], 1);
        for (std::size_t i = 0; i < form.size(); ++i) form[i] -= other[i];
      }
  }
  return forms;
}

/// All products of forms of degree (d, d, d) with monomials, of degree (e, e, e).
ResidueMatrix multiples(const std::vector<Form>& forms, std::size_t d, std::size_t e) {
  ResidueMatrix rows;
  for (const Form& form : forms)
    for (std::size_t m = 0; m < monomials(e - d); ++m) {
      Form monomial(monomials(e - d));
      monomial[m] = Residue(1);
      rows.push_back(product(form, d, monomial, e - d));
    }
  return rows;
}

}  // namespace

std::optional<int> count_closings(const std::vector<bool>& meets, std::mt19937_64& random) {
  const std::vector<DualQuaternion> h = random_hinges(meets, random);
  const ResidueMatrix f = product_of_rotations(h[0], h[1], h[2]), g = product_of_rotations(h[5], h[4], h[3]);
  if (rank(f) != 8 || rank(g) != 8) return std::nullopt;
  const std::vector<Form> quadrics = minors(coordinates(f, g));
  const auto dimension = [&](std::size_t degree) {
    return static_cast<int>(monomials(degree)) - rank(multiples(quadrics, 2, degree));
  };
  ResidueMatrix images = multiples(quadrics, 2, 4);
  Form factor(8);
  for (Residue& coefficient : factor) coefficient = Residue::random(random);
  for (Form& form : multiples({factor}, 1, 4)) images.push_back(std::move(form));
  const bool is_onto = rank(std::move(images)) == static_cast<int>(monomials(4));
  const int count = dimension(3);
  return is_onto && dimension(4) == count ? std::optional(count) : std::nullopt;
}

}  // namespace gcs::samples
