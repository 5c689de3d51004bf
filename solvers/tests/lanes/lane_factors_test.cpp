#include "solvers/lanes/lane_factors.hpp"

#include <Eigen/LU>
#include <catch2/catch.hpp>

#include "solvers/model/distance_system.hpp"
#include "solvers/tests/sample_problems.hpp"

using namespace gcs;
using namespace gcs::portable_lanes;

namespace {

/// A system with its Jacobian and right-hand side at one random point for each lane.
struct Samples {
  explicit Samples(const SquareSystem& system, std::mt19937_64& random)
      : n(system.unknowns), elimination(order_elimination(system, random)) {
    for (int lane = 0; lane < Lanes::count; ++lane) {
      const ComplexVectorX entries = jacobian_at(system, random_complex_vector(n, random));
      matrices.push_back(Eigen::Map<const Eigen::MatrixXcd>(entries.data(), n, n).transpose());
      const ComplexVectorX right = random_complex_vector(n, random);
      rights.push_back(Eigen::Map<const Eigen::VectorXcd>(right.data(), n));
    }
  }

  void fill(std::vector<Complex<Lanes>>& entries) const {
    for (int lane = 0; lane < Lanes::count; ++lane)
      for (int e = 0; e < n; ++e)
        for (int i = 0; i < n; ++i)
          if (const int entry = elimination.entry(e, i); entry >= 0)
            set(entries[entry], lane, matrices[lane](e, i));
  }

  int n;
  Elimination elimination;
  std::vector<Eigen::MatrixXcd> matrices;
  std::vector<Eigen::VectorXcd> rights;
};

}  // namespace

TEST_CASE("factors in lanes solve what a pivoting factorisation solves") {
  std::mt19937_64 random(21);
  for (const ProblemStatement& problem : {samples::k33(), samples::octahedron()}) {
    const Samples sample(square_system(DistanceSystem(Scene(problem))), random);
    LaneFactors<Complex<Lanes>> factors(sample.elimination);
    // Twice, as the second Jacobian must not meet what is left of the first one.
    for (int round = 0; round < 2; ++round) {
      sample.fill(factors.cleared_entries());
      factors.factorise();
    }
    std::vector<Complex<Lanes>> z(sample.n);
    for (int lane = 0; lane < Lanes::count; ++lane)
      for (int k = 0; k < sample.n; ++k) set(z[k], lane, sample.rights[lane][sample.elimination.equation[k]]);
    factors.solve(z);
    for (int lane = 0; lane < Lanes::count; ++lane) {
      const Eigen::VectorXcd expected = sample.matrices[lane].partialPivLu().solve(sample.rights[lane]);
      for (int k = 0; k < sample.n; ++k) {
        const std::complex<double> found(z[k].re.lane(lane), z[k].im.lane(lane));
        // The order is chosen for pivots that are not small: rounding grows by little more than the
        // condition.
        CHECK(std::abs(found - expected[sample.elimination.unknown[k]]) <= 1e-10 * expected.norm());
      }
    }
  }
}
