#include "solvers/lanes/distance_conditions.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <random>
#include <vector>

#include "solvers/tests/available_sets.hpp"

using namespace gcs;

namespace {

/// Points in the plane, the first at rest and the second on an axis, and random pairs of them.
DifferenceMatrix random_matrix(int points, int rows, std::mt19937_64& random) {
  const auto column = [](int point, int axis) {
    if (point < 2) return point == 1 && axis == 0 ? 0 : -1;
    return 2 * point - 3 + axis;
  };
  DifferenceMatrix matrix{rows, 2 * points - 3, {}};
  std::uniform_int_distribution<int> any(0, points - 1);
  for (int row = 0; row < rows; ++row) {
    const int a = 2 + row % (points - 2);
    int b = any(random);
    while (b == a) b = any(random);
    for (int axis = 0; axis < 2; ++axis) {
      const int of_a = 3 * a + axis, of_b = 3 * b + axis;
      matrix.entries.push_back({row, column(a, axis), of_a, of_b});
      if (column(b, axis) >= 0) matrix.entries.push_back({row, column(b, axis), of_b, of_a});
    }
  }
  return matrix;
}

struct Coordinates {
  std::vector<double> real, imaginary;

  PointCoordinates view() const { return {real.data(), imaginary.empty() ? nullptr : imaginary.data()}; }
};

std::vector<Coordinates> random_figures(int count, int points, double size, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0, size);
  std::vector<Coordinates> figures(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    Coordinates& figure = figures[static_cast<std::size_t>(i)];
    for (int c = 0; c < 3 * points; ++c) figure.real.push_back(normal(random));
    for (int c = 0; c < 3 * points && i % 3 != 0; ++c)
      figure.imaginary.push_back(normal(random) * std::pow(10.0, -i % 7));
  }
  return figures;
}

std::vector<double> conditions_of(const DifferenceMatrix& matrix, const std::vector<Coordinates>& figures,
                                  InstructionSet set) {
  std::vector<PointCoordinates> views;
  for (const Coordinates& figure : figures) views.push_back(figure.view());
  return normalised_conditions(matrix, views, set);
}

/// By one-sided Jacobi rotations.
double condition_by_definition(const DifferenceMatrix& matrix, const Coordinates& figure) {
  Eigen::MatrixXcd dense = Eigen::MatrixXcd::Zero(matrix.rows, matrix.columns);
  for (const auto& entry : matrix.entries) {
    const auto difference = [&](const std::vector<double>& x) {
      return x[entry.minuend] - x[entry.subtrahend];
    };
    dense(entry.row, entry.column) = {difference(figure.real),
                                      figure.imaginary.empty() ? 0 : difference(figure.imaginary)};
  }
  for (Eigen::Index row = 0; row < dense.rows(); ++row) dense.row(row) /= dense.row(row).stableNorm();
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXcd>(dense).singularValues();
  return values.maxCoeff() / values.minCoeff();
}

}  // namespace

TEST_CASE("condition numbers in lanes are those of singular values, for all instructions to the last bit") {
  std::mt19937_64 random(1);
  struct Size {
    int points, rows;
    double size;
  };
  for (const auto& [points, rows, size] : {Size{3, 3, 1}, Size{8, 13, 1}, Size{8, 20, 1}, Size{9, 7, 1},
                                           Size{12, 21, 1e150}, Size{6, 9, 1e-150}}) {
    const DifferenceMatrix matrix = random_matrix(points, rows, random);
    const std::vector<Coordinates> figures = random_figures(11, points, size, random);
    const std::vector<double> conditions = conditions_of(matrix, figures, InstructionSet::portable);
    for (std::size_t i = 0; i < figures.size(); ++i) {
      const double expected = condition_by_definition(matrix, figures[i]);
      if (expected < 1e9)
        CHECK(std::abs(conditions[i] / expected - 1) < 1e-14 * (1 + expected));
      else
        CHECK(conditions[i] > 1e8);
    }
    for (const InstructionSet set : samples::available_sets()) {
      CHECK(conditions_of(matrix, figures, set) == conditions);
      CHECK(conditions_of(matrix, {figures[4]}, set).front() == conditions[4]);
    }
  }
}

TEST_CASE("figures without a row, and such that are no numbers, have no finite condition in lanes") {
  std::mt19937_64 random(2);
  const DifferenceMatrix matrix = random_matrix(5, 7, random);
  std::vector<Coordinates> figures = random_figures(3, 5, 1, random);
  const double regular = conditions_of(matrix, figures, InstructionSet::portable)[1];
  std::fill(figures[0].real.begin(), figures[0].real.end(), 1.0);
  figures[2].imaginary[7] = std::numeric_limits<double>::quiet_NaN();
  for (const InstructionSet set : samples::available_sets()) {
    const std::vector<double> conditions = conditions_of(matrix, figures, set);
    CHECK(std::isinf(conditions[0]));
    CHECK(conditions[1] == regular);
    CHECK(std::isinf(conditions[2]));
  }
}
