/// The simplex method against all vertices of small programs.

#include "solvers/subdivision/boxed_simplex.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <optional>

#include "solvers/tests/random_numbers.hpp"

using namespace gcs;

namespace {

struct Program {
  Eigen::MatrixXd rows;
  Eigen::VectorXd low, high;
};

/// Three columns and four slabs, of which few are empty with the box.
Program random_program(samples::RandomNumbers& random) {
  Program program{Eigen::MatrixXd(4, 3), Eigen::VectorXd(4), Eigen::VectorXd(4)};
  for (double& entry : program.rows.reshaped()) entry = random.uniform(-1, 1);
  for (int e = 0; e < 4; ++e) {
    const double middle = random.uniform(-0.8, 0.8), half = random.uniform(0, 0.4);
    program.low[e] = middle - half;
    program.high[e] = middle + half;
  }
  return program;
}

/// The least c·z by looking at every point where three bounds are met; nothing where no point keeps all.
std::optional<double> least_by_vertices(const Program& program, const Eigen::Vector3d& cost) {
  Eigen::MatrixXd planes(7, 3);
  planes << program.rows, Eigen::Matrix3d::Identity();
  Eigen::VectorXd low(7), high(7);
  low << program.low, Eigen::Vector3d::Constant(-1);
  high << program.high, Eigen::Vector3d::Constant(1);
  std::optional<double> least;
  for (int i = 0; i < 7; ++i)
    for (int j = 0; j < i; ++j)
      for (int k = 0; k < j; ++k)
        for (int sides = 0; sides < 8; ++sides) {
          Eigen::Matrix3d matrix;
          matrix << planes.row(i), planes.row(j), planes.row(k);
          if (std::abs(matrix.determinant()) < 1e-9) continue;
          const auto side = [&](int plane, int bit) {
            return (sides >> bit & 1) != 0 ? high[plane] : low[plane];
          };
          const Eigen::Vector3d z =
              matrix.partialPivLu().solve(Eigen::Vector3d(side(i, 0), side(j, 1), side(k, 2)));
          const Eigen::ArrayXd values = (planes * z).array();
          if ((values < low.array() - 1e-9).any() || (values > high.array() + 1e-9).any()) continue;
          least = std::min(least.value_or(std::numeric_limits<double>::infinity()), cost.dot(z));
        }
  return least;
}

}  // namespace

TEST_CASE("the simplex method finds what the best vertex has, or that there is none") {
  samples::RandomNumbers random(1947);
  int empty = 0, solved = 0;
  for (int i = 0; i < 500; ++i) {
    const Program program = random_program(random);
    BoxedSimplex simplex(program.rows, program.low, program.high);
    const BoxedSimplex::End end = simplex.find_point();
    const bool is_possible = least_by_vertices(program, Eigen::Vector3d::UnitX()).has_value();
    CHECK(end == (is_possible ? BoxedSimplex::End::feasible : BoxedSimplex::End::infeasible));
    if (end == BoxedSimplex::End::infeasible) {
      ++empty;
      // 0 = Σ y s − (Aᵀy)·z has no solution within the bounds.
      const Eigen::VectorXd y = simplex.contradiction();
      const double middle = y.dot(program.low + program.high) / 2;
      const double reach =
          y.cwiseAbs().dot(program.high - program.low) / 2 + (program.rows.transpose() * y).lpNorm<1>();
      CHECK(std::abs(middle) > reach);
    }
    if (end != BoxedSimplex::End::feasible) continue;
    ++solved;
    for (int j = 0; j < 3; ++j)
      for (const double sign : {1.0, -1.0}) {
        const Eigen::VectorXd y = simplex.minimise(j, sign);
        const auto least = least_by_vertices(program, sign * Eigen::Vector3d::Unit(j));
        REQUIRE(least);
        CHECK(sign * simplex.value(j) == Approx(*least).margin(1e-7));
        // The multipliers alone give the same bound.
        const Eigen::Vector3d rest = Eigen::Vector3d::Unit(j) - program.rows.transpose() * y;
        const double middle = y.dot(program.low + program.high) / 2;
        const double reach = y.cwiseAbs().dot(program.high - program.low) / 2 + rest.lpNorm<1>();
        CHECK(sign * middle - reach == Approx(*least).margin(1e-7));
      }
  }
  CHECK(empty > 20);
  CHECK(solved > 100);
}
