#include "solvers/lanes/column_kernels.hpp"

#include <Eigen/Core>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "solvers/lanes/lane_functions.hpp"
#include "solvers/tests/available_sets.hpp"

using namespace gcs;

namespace {

/// Shorter than any vector, just as long, and longer than several with and without a rest.
constexpr std::array row_counts{1, 2, 3, 7, 8, 9, 16, 23, 31, 32, 33, 64, 90};

struct Sample {
  Sample(Eigen::Index rows, Eigen::Index count, std::mt19937_64& random)
      : matrix(rows, count), columns(rows, count) {
    std::normal_distribution<double> normal;
    for (Eigen::Index j = 0; j < count; ++j)
      for (Eigen::Index i = 0; i < rows; ++i) columns.column(j)[i] = matrix(i, j) = normal(random);
  }

  Eigen::MatrixXd matrix;
  AlignedColumns columns;
};

/// What a kernel writes, with the same bits for every set and nothing behind the last row.
template <class Write>
Eigen::VectorXd written(Eigen::Index rows, const Write& write) {
  constexpr double untouched = -7;
  Eigen::VectorXd first;
  for (const InstructionSet set : samples::available_sets()) {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(rows + 8, untouched);
    write(lane_functions(set).columns, result.data());
    CHECK(result.tail(8) == Eigen::VectorXd::Constant(8, untouched));
    if (first.size() == 0) first = result.head(rows);
    CHECK(first == result.head(rows));
  }
  return first;
}

}  // namespace

TEST_CASE("columns are combined as the product with the factors says") {
  std::mt19937_64 random(1);
  for (const Eigen::Index rows : row_counts)
    for (const Eigen::Index count : {1, 2, 9}) {
      const Sample sample(rows, count, random);
      const Eigen::VectorXd factors = Sample(count, 1, random).matrix;
      const Eigen::VectorXd sum = written(rows, [&](const ColumnKernels& kernels, double* result) {
        kernels.combine(sample.columns.from(0), count, factors.data(), result);
      });
      CHECK((sum - sample.matrix * factors).norm() <= 1e-14 * (1 + factors.norm() * sample.matrix.norm()));
    }
}

TEST_CASE("columns are the coefficients of a polynomial") {
  std::mt19937_64 random(2);
  for (const Eigen::Index rows : row_counts) {
    constexpr Eigen::Index count = 11;
    const Sample sample(rows, count, random);
    const Eigen::VectorXd weights = Sample(count, 1, random).matrix;
    for (const double s : {0.0, -0.4, 1.5}) {
      const Eigen::VectorXd value = written(rows, [&](const ColumnKernels& kernels, double* result) {
        kernels.evaluate(sample.columns.from(0), count, weights.data(), s, result);
      });
      Eigen::VectorXd slow = Eigen::VectorXd::Zero(rows);
      double size = 0;
      for (Eigen::Index j = 0; j < count; ++j) {
        slow += weights[j] * std::pow(s, j) * sample.matrix.col(j);
        size += std::abs(weights[j] * std::pow(s, j)) * sample.matrix.col(j).norm();
      }
      CHECK((value - slow).norm() <= 1e-14 * size);
    }
  }
}

TEST_CASE("a half convolution is half the double sum") {
  std::mt19937_64 random(3);
  for (const Eigen::Index rows : row_counts) {
    const Sample sample(rows, 12, random);
    for (const Eigen::Index first : {1, 2})
      for (Eigen::Index n = 1; n <= 12; ++n) {
        const Eigen::VectorXd half = written(rows, [&](const ColumnKernels& kernels, double* result) {
          kernels.half_convolution(sample.columns.from(0), first, n, result);
        });
        Eigen::VectorXd slow = Eigen::VectorXd::Zero(rows);
        for (Eigen::Index i = first; i <= n - first; ++i)
          slow += sample.matrix.col(i).cwiseProduct(sample.matrix.col(n - i)) / 2;
        CHECK((half - slow).norm() <= 1e-14 * sample.matrix.squaredNorm());
      }
  }
}

TEST_CASE("squares are summed row by row") {
  std::mt19937_64 random(5);
  for (const Eigen::Index rows : row_counts)
    for (const Eigen::Index count : {0, 1, 7}) {
      const Sample sample(rows, count, random);
      const Eigen::VectorXd sums = written(rows, [&](const ColumnKernels& kernels, double* result) {
        kernels.squares(sample.columns.from(0), count, result);
      });
      CHECK((sums - sample.matrix.rowwise().squaredNorm()).norm() <= 1e-14 * sample.matrix.squaredNorm());
    }
}

TEST_CASE("columns are substituted one after the other") {
  std::mt19937_64 random(4);
  const std::vector<ColumnStep> steps{{2, 0, 2, 0.5}, {0, 2, 2, -3}, {3, 2, 5, 1}};
  const std::vector<int> sources{0, 1, 2, 0, 1};
  const Eigen::VectorXd factors = Sample(5, 1, random).matrix;
  for (const Eigen::Index rows : {8, 16, 24, 32, 40, 96}) {
    const Sample sample(rows, 4, random);
    Eigen::MatrixXd slow = sample.matrix;
    for (const ColumnStep& step : steps) {
      slow.col(step.target) *= step.scale;
      for (int i = step.first; i < step.last; ++i)
        slow.col(step.target) -= factors[i] * slow.col(sources[static_cast<std::size_t>(i)]);
    }
    for (const InstructionSet set : samples::available_sets()) {
      AlignedColumns columns = sample.columns;
      lane_functions(set).columns.substitute(columns.column(0), columns.stride(), steps.data(),
                                             std::ssize(steps), sources.data(), factors.data());
      for (Eigen::Index j = 0; j < 4; ++j)
        for (Eigen::Index i = 0; i < rows; ++i) CHECK(columns.column(j)[i] == slow(i, j));
    }
  }
}
