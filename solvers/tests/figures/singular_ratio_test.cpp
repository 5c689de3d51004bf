#include "solvers/figures/singular_ratio.hpp"

#include <Eigen/QR>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <random>

using namespace gcs;

namespace {

Eigen::MatrixXcd random_unitary(Eigen::Index size, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXcd matrix(size, size);
  for (Eigen::Index i = 0; i < size; ++i)
    for (Eigen::Index j = 0; j < size; ++j) {
      const double real = normal(random), imaginary = normal(random);
      matrix(i, j) = {real, imaginary};
    }
  return matrix.householderQr().householderQ();
}

/// Of singular values from 1 down to 1/ratio, evenly in their logarithm.
Eigen::MatrixXcd matrix_of_ratio(Eigen::Index size, double ratio, std::mt19937_64& random) {
  Eigen::VectorXcd values(size);
  for (Eigen::Index i = 0; i < size; ++i)
    values[i] = std::pow(ratio, -static_cast<double>(i) / static_cast<double>(size - 1));
  const Eigen::MatrixXcd left = random_unitary(size, random);
  return left * values.asDiagonal() * random_unitary(size, random);
}

}  // namespace

TEST_CASE("rounded ratios of singular values are those that a matrix was made of") {
  std::mt19937_64 random(5);
  for (const double ratio : {1.0, 30.0, 9e3, 1.1e4, 1e6, 1e9})
    for (const Eigen::Index size : {2, 9, 24}) {
      // The matrix is rounded, which moves its smallest singular value by as much as its largest.
      const double limit = 1e-7 + 1e-15 * ratio * static_cast<double>(size);
      CHECK(std::abs(rounded_singular_ratio(matrix_of_ratio(size, ratio, random)) / ratio - 1) < limit);
    }
}

TEST_CASE("more equations than unknowns have the ratio of the singular values that there are") {
  std::mt19937_64 random(6);
  for (const double ratio : {30.0, 1e6}) {
    Eigen::MatrixXcd tall = Eigen::MatrixXcd::Zero(11, 8);
    tall.topRows(8) = matrix_of_ratio(8, ratio, random);
    const Eigen::MatrixXcd turned = random_unitary(11, random) * tall;
    CHECK(std::abs(rounded_singular_ratio(turned) / ratio - 1) < 1e-7 + 1e-14 * ratio);
  }
}

TEST_CASE("a singular matrix has no finite ratio that a regular one has") {
  Eigen::MatrixXcd matrix = Eigen::MatrixXcd::Identity(4, 4);
  matrix.row(3) = matrix.row(2);
  CHECK(rounded_singular_ratio(matrix) > 1e15);
  CHECK(rounded_singular_ratio(Eigen::MatrixXcd(Eigen::MatrixXcd::Zero(3, 3))) > 1e15);
}
