#include "solvers/lanes/sparse_inverse.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "solvers/tests/available_sets.hpp"

using namespace gcs;

namespace {

/// Three entries in a row besides the diagonal, and a last row and column without zeros, as bordered matrices have them.
Eigen::MatrixXd random_pattern(int n, std::mt19937_64& random) {
  Eigen::MatrixXd pattern = Eigen::MatrixXd::Identity(n, n);
  std::uniform_int_distribution<int> any(0, n - 1);
  for (int row = 0; row < n; ++row)
    for (int i = 0; i < 3; ++i) pattern(row, any(random)) = 1;
  pattern.row(n - 1).setOnes();
  pattern.col(n - 1).setOnes();
  return pattern;
}

Eigen::MatrixXd random_matrix(const Eigen::MatrixXd& pattern, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  return pattern.unaryExpr([&](double entry) { return entry * normal(random); });
}

Eigen::VectorXd applied(SparseInverse& inverse, const Eigen::VectorXd& right) {
  Eigen::VectorXd result(right.size());
  inverse.apply(right, result);
  return result;
}

/// Against a factorisation with all pivots to choose from. The rounding of an inverse grows with the condition number, and
/// an order that is kept may lose three digits more.
void check_inverse(SparseInverse& inverse, const Eigen::MatrixXd& matrix) {
  const Eigen::FullPivLU<Eigen::MatrixXd> factors(matrix);
  const double condition = matrix.norm() * factors.inverse().norm();
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(matrix.rows(), -1, 2);
  const Eigen::VectorXd expected = factors.solve(right);
  CHECK((applied(inverse, right) - expected).norm() <= 1e-13 * condition * expected.norm());
  CHECK(inverse.determinant_sign() == (factors.determinant() < 0 ? -1 : 1));
}

}  // namespace

TEST_CASE("a sparse inverse solves what a pivoting factorisation solves") {
  std::mt19937_64 random(1);
  for (const int n : {1, 2, 5, 8, 13, 31, 40})
    for (int trial = 0; trial < 20; ++trial) {
      const Eigen::MatrixXd pattern = random_pattern(n, random);
      SparseInverse inverse(pattern);
      const Eigen::MatrixXd matrix = random_matrix(pattern, random);
      for (const double scale : {1.0, 1e-140, 1e140, -1.0}) {
        const Eigen::MatrixXd scaled = scale * matrix;
        inverse.compute(scaled);
        if (std::abs(scale) == 1) {
          check_inverse(inverse, scaled);
        } else {
          const Eigen::VectorXd right = scale * Eigen::VectorXd::Ones(n);
          const Eigen::VectorXd x = applied(inverse, right);
          CHECK((matrix * x - Eigen::VectorXd::Ones(n)).norm() <= 1e-9 * (1 + matrix.norm() * x.norm()));
        }
      }
      CHECK(inverse.orders_found() == 1);
    }
}

TEST_CASE("a sparse inverse keeps its orders while pivots pass through zero") {
  std::mt19937_64 random(2);
  constexpr int n = 21, steps = 400;
  const Eigen::MatrixXd pattern = random_pattern(n, random);
  const Eigen::MatrixXd even = random_matrix(pattern, random), odd = random_matrix(pattern, random);
  SparseInverse inverse(pattern);
  for (int step = 0; step < steps; ++step) {
    const double angle = 2 * M_PI * step / steps;
    const Eigen::MatrixXd matrix = std::cos(angle) * even + std::sin(angle) * odd;
    inverse.compute(matrix);
    check_inverse(inverse, matrix);
  }
  CHECK(inverse.orders_found() > 1);
  CHECK(inverse.orders_found() <= steps / 10);
}

TEST_CASE("another order is found where a pivot is zero") {
  Eigen::MatrixXd matrix(3, 3);
  matrix << 1, 2, 0, 3, 1, 1, 0, 1, 2;
  const Eigen::MatrixXd pattern = (matrix.array() != 0).cast<double>();
  SparseInverse inverse(pattern);
  inverse.compute(matrix);
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      Eigen::MatrixXd changed = matrix;
      changed(row, column) = 0;
      if (std::abs(changed.determinant()) < 0.5) continue;
      inverse.compute(changed);
      check_inverse(inverse, changed);
    }
}

TEST_CASE("a singular matrix has no inverse") {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Ones(4, 4);
  SparseInverse inverse(matrix);
  inverse.compute(matrix);
  CHECK(inverse.determinant_sign() == 0);
  CHECK(applied(inverse, Eigen::VectorXd::Ones(4)).array().isNaN().all());
  matrix.diagonal().setConstant(3);
  inverse.compute(matrix);
  check_inverse(inverse, matrix);
}

TEST_CASE("a product with an ill-conditioned inverse leaves no more than a solution by factors") {
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  constexpr int n = 21;
  for (const double smallest : {1e-3, 1e-6, 1e-9}) {
    const Eigen::MatrixXd pattern = random_pattern(n, random);
    Eigen::MatrixXd matrix = random_matrix(pattern, random);
    // The last row becomes a combination of others, but for a small part.
    matrix.row(n - 1) = smallest * matrix.row(n - 1) + matrix.topRows(n - 1).colwise().sum();
    SparseInverse inverse(pattern);
    inverse.compute(matrix);
    const Eigen::VectorXd x = Eigen::VectorXd::NullaryExpr(n, [&] { return normal(random); });
    const Eigen::VectorXd right = matrix * x, found = applied(inverse, right);
    CHECK((matrix * found - right).norm() <= 1e-14 * matrix.norm() * found.norm());
  }
}

TEST_CASE("the bits of a sparse inverse do not depend on the instructions") {
  std::mt19937_64 random(3);
  for (const int n : {3, 8, 31}) {
    const Eigen::MatrixXd pattern = random_pattern(n, random), matrix = random_matrix(pattern, random);
    std::vector<Eigen::VectorXd> results;
    for (const InstructionSet set : samples::available_sets()) {
      SparseInverse inverse(pattern, set);
      inverse.compute(matrix);
      results.push_back(applied(inverse, Eigen::VectorXd::LinSpaced(n, 1, 2)));
    }
    for (const Eigen::VectorXd& result : results) CHECK(result == results.front());
  }
}
