#pragma once
/// The linearised plan: how all points move when the right sides of the sphere equations change. One sweep
/// over the instructions solves, for every used edge e between a placed point p and a centre c,
///   (p − c)·(p' − c') = right_e
/// for the moves p', point by point, by the inverse of the three normals at each. Derivatives by a driving
/// parameter and Taylor coefficients of any order are such moves.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "solvers/construction/plan.hpp"

namespace gcs {

class PlanSweep {
 public:
  /// Edges are the constraints of the problem in their order, then the driven spheres in that of their
  /// parameters.
  void configure(const Plan& plan, int constraints);
  /// Takes normals and their inverses at a figure. Precondition: it satisfies the plan, away from its
  /// boundary configurations.
  void linearise(const Plan& plan, const Eigen::Matrix3Xd& points);

  /// Moves of the points placed by instruction `first` and later, where those placed before stand still.
  /// `right`: per edge. `move`: dimension · point + axis, zero on entry.
  void solve(const Eigen::VectorXd& right, std::size_t first, double* move) const;

 private:
  template <int Dimension>
  void solve_in(const Eigen::VectorXd& right, std::size_t first, double* move) const;

  /// One instruction, padded to three spheres: where there are fewer the inverse has zero columns.
  struct Step {
    Eigen::Index point = 0;  ///< its first coordinate
    std::array<Eigen::Index, 3> edge{};
    std::array<Eigen::Index, 3> center{};            ///< first coordinate of the sphere's centre
    Eigen::Matrix3d pull = Eigen::Matrix3d::Zero();  ///< row i: p − c_i, zero where c_i cannot move
    Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  };

  int dimension_ = 3;
  std::vector<Step> steps_;
};

}  // namespace gcs
