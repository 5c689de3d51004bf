#include "solvers/tangents/tangent_algebra.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "solvers/tangents/eigenvalue_clusters.hpp"
#include "solvers/tests/random_numbers.hpp"

using namespace gcs;
using gcs::samples::RandomNumbers;

namespace {

using Complex = std::complex<double>;

FourSpheres random_spheres(RandomNumbers& random) {
  FourSpheres spheres;
  for (Sphere& sphere : spheres) {
    sphere.center = random.point(3, 1);
    sphere.square = {random.uniform(0.1, 1), 0};
  }
  return spheres;
}

Eigen::Matrix3d random_rotation(RandomNumbers& random) {
  return Eigen::AngleAxisd(random.uniform(-3, 3), random.point(3, 1).normalized()).toRotationMatrix();
}

AlgebraMatrix power(const AlgebraMatrix& matrix, int exponent) {
  AlgebraMatrix result = AlgebraMatrix::Identity();
  for (int i = 0; i < exponent; ++i) result *= matrix;
  return result;
}

/// A polynomial of commuting matrices, with g = 1, and the sum of its terms' norms.
struct MatrixValue {
  AlgebraMatrix value = AlgebraMatrix::Zero();
  double size = 0;

  void add(const AlgebraMatrix& term) {
    value += term;
    size += term.norm();
  }
};

template <int degree>
MatrixValue value_of(const Form<degree>& form, const TangentAlgebra& algebra) {
  MatrixValue result;
  for (int i = 0; i < form.size(); ++i) {
    const TernaryExponents e = exponents(i);
    result.add(form[i] * power(algebra.times_x(), e.x) * power(algebra.times_y(), e.y));
  }
  return result;
}

double commutator(const AlgebraMatrix& a, const AlgebraMatrix& b) {
  return (a * b - b * a).norm() / (a.norm() * b.norm());
}

}  // namespace

TEST_CASE("the matrices of multiplication commute and satisfy the tangent equations") {
  // Rounding times the condition of the basis: 1e-16 times 1e6 at most for spheres like these.
  constexpr double rounding = 1e-9;
  RandomNumbers random(3);
  for (int i = 0; i < 20; ++i) {
    const TangentEquations equations(random_spheres(random), random_rotation(random));
    const auto algebra = TangentAlgebra::of(equations);
    REQUIRE(algebra);
    const AlgebraMatrix tau = algebra->times_tau(equations);
    CHECK(commutator(algebra->times_x(), algebra->times_y()) <= rounding);
    CHECK(commutator(algebra->times_x(), tau) <= rounding);
    CHECK(commutator(algebra->times_y(), tau) <= rounding);
    const MatrixValue kappa = value_of<2>(equations.kappa(), *algebra);
    CHECK((equations.h() * tau - kappa.value).norm() <= rounding * kappa.size);
    const MatrixValue l = value_of<1>(equations.l(), *algebra), s = value_of<3>(equations.s(), *algebra);
    CHECK((tau * l.value + s.value).norm() <= rounding * s.size);
    const MatrixValue rho = value_of<4>(equations.rho(), *algebra);
    CHECK((tau * tau - rho.value).norm() <= rounding * rho.size);
  }
}

TEST_CASE("an eigenvector's tau squared is rho") {
  RandomNumbers random(4);
  const TangentEquations equations(random_spheres(random), random_rotation(random));
  const auto algebra = TangentAlgebra::of(equations);
  REQUIRE(algebra);
  const Eigen::EigenSolver<AlgebraMatrix> solver(algebra->times_x());
  for (int i = 0; i < tangent_count; ++i) {
    const AlgebraVector<Complex> w = solver.eigenvectors().col(i);
    const Complex x = solver.eigenvalues()[i], y = w.dot(algebra->times_y().cast<Complex>() * w);
    const Complex tau = algebra->tau(w, x, y);
    const Eigen::Vector3cd u(x, y, 1);
    const double size = equations.rho().cwiseAbs().sum() * std::pow(u.norm(), 4);
    CHECK(std::abs(tau * tau - form_value<4>(equations.rho(), u)) <= 1e-8 * size);
  }
}

TEST_CASE("clusters are chains, and may be one value as far as rounding spreads it") {
  const std::vector<Complex> values{1, 2, Complex(1, 2e-6), Complex(1, 1e-6)};
  const auto clusters = clusters_of(values, 0.6e-6);
  REQUIRE(clusters.size() == 2);
  CHECK(clusters[0].size() == 3);
  CHECK(clusters[1] == EigenvalueCluster{1});
  CHECK(std::abs(mean_of(values, clusters[0]) - Complex(1, 1e-6)) <= 1e-15);
  CHECK(clusters_of(values, 0.4e-6).size() == 4);
  // eps^(1/2) is 1.5e-8, eps^(1/4) is 1.2e-4.
  const std::vector<Complex> near{1 + 1e-4, 1 - 1e-4, Complex(1, 1e-4), Complex(1, -1e-4)};
  CHECK_FALSE(may_be_one(near, {0, 1}));
  CHECK(may_be_one(near, {0, 1, 2, 3}));
}

TEST_CASE("the mean of a triple eigenvalue is right to rounding on its invariant subspace") {
  RandomNumbers random(5);
  AlgebraMatrix jordan = AlgebraMatrix::Zero(), basis;
  for (int i = 0; i < tangent_count; ++i) jordan(i, i) = i < 3 ? 2 : i;
  jordan(0, 1) = jordan(1, 2) = 1;
  for (int i = 0; i < tangent_count; ++i)
    for (int j = 0; j < tangent_count; ++j) basis(i, j) = random.uniform(-1, 1) + (i == j ? 3 : 0);
  const AlgebraMatrix matrix = basis * jordan * basis.inverse();
  const Subspace subspace = invariant_subspace(matrix, 2.001, 3);
  const Restriction restriction = restricted(matrix, subspace);
  REQUIRE(subspace.cols() == 3);
  CHECK((matrix.cast<Complex>() * subspace - subspace * restriction).norm() <= 1e-11 * matrix.norm());
  CHECK(std::abs(restriction.trace() / 3.0 - 2.0) <= 1e-10);
}
