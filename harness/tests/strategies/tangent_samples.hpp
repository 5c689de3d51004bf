#pragma once
/// Lines at given distances from four given points: random ones, and whether two solves found the same.

#include <Eigen/Core>
#include <random>

#include "harness/solving/solve_run.hpp"
#include "harness/tests/strategies/line_precision.hpp"

namespace gcs {

/// Column i of `centers` at the distance `distances[i]` from the line.
ProblemStatement spheres(const Eigen::Matrix<double, 3, 4>& centers, const Eigen::Vector4d& distances);
/// What the problem gives, if all its distances are lengths.
FourDistances distances_of(const ProblemStatement& problem);

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  /// From −1 to 1.
  double operator()();

  Eigen::Matrix<double, 3, 4> centers();
  Eigen::Vector4d distances();
  /// A unit vector.
  Eigen::Vector3d direction();
  Eigen::Matrix3d rotation();
  /// Random centres, mapped by `shape`, and distances.
  ProblemStatement problem(const Eigen::Matrix3d& shape);

 private:
  std::mt19937_64 engine_;
};

int real_ones(const SolveRun& run);

/// Each line of one run is one of the other, to 1e-9, with its multiplicity.
bool have_same_lines(const SolveRun& a, const SolveRun& b);

}  // namespace gcs
