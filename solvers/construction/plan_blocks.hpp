#pragma once
/// The equations of a general scene in the order of a construction plan: block by block, as Algorithm 1 of [I] evaluates
/// instruction by instruction.

#include <Eigen/Core>
#include <vector>

#include "solvers/construction/element_plan.hpp"
#include "solvers/elements/scene_system.hpp"

namespace gcs {

/// The unknowns that a step finds, and all equations between these and what is placed before. An unknown of no element,
/// such as the length of a segment, is found as soon as there are equations enough.
struct PlanBlock {
  std::vector<int> unknowns;
  std::vector<int> equations;
};

/// One block for each step. Every unknown and every equation is in one of them. Precondition: the plan places all elements
/// that have unknowns.
std::vector<PlanBlock> plan_blocks(const SceneSystem& system, const ElementPlan& plan);

/// A plan at a figure. Of the equations of each block, as the rows of a Jacobian made 1 long, those are used that pivoting
/// finds the farthest from each other. Where an equation's row is nearer than α to the span of those before it, which is
/// where its surface is nearly tangent to what they leave open, a driving parameter takes its place: how far the unknowns
/// are along a direction that the used equations leave open. The equations that are not used are the removed ones.
///
/// This is crossing_sine of construction/boundary.hpp for any surfaces, with a plane in place of a driven sphere.
class BlockPlan {
 public:
  BlockPlan() = default;
  /// Precondition: as many equations as unknowns, which are numbered 0, 1, …
  explicit BlockPlan(std::vector<PlanBlock> blocks);

  /// Whether some block is nearer than α/2 to a tangency, or has a driving parameter that it would not need even at 2α.
  /// Between these bounds a plan stays as it is.
  bool is_due(const Eigen::MatrixXd& jacobian, double alpha) const;
  /// Chooses anew in the blocks for which that is so, in all of them where nothing is chosen yet.
  void choose(const Eigen::MatrixXd& jacobian, double alpha);
  /// How far the nearest block is from a tangency, in [0, 1].
  double distance_from_tangency(const Eigen::MatrixXd& jacobian) const;

  int driving_parameters() const { return driving_parameters_; }
  const std::vector<int>& removed() const { return removed_; }
  /// The driving parameters at these unknowns.
  Eigen::VectorXd driven(const Eigen::VectorXd& x) const;

  /// Inverts the blocks. The last column of the Jacobian, of t, is not theirs.
  void linearise(const Eigen::MatrixXd& jacobian);
  /// The sign of the product of the blocks' determinants.
  int sign() const { return sign_; }
  /// The changes of all unknowns at a given one of t, the last entry of `change`, at which the used equations change by
  /// `right` and the driving parameters by `driven`. The Jacobian: that of linearise.
  void solve(const Eigen::MatrixXd& jacobian, const Eigen::VectorXd& right, const Eigen::VectorXd& driven,
             Eigen::VectorXd& change) const;

 private:
  struct Choice {
    std::vector<int> used;
    Eigen::MatrixXd directions;  ///< rows of length 1 in the block's unknowns
    Eigen::MatrixXd inverse;     ///< of the used equations' rows, then the directions
  };
  Eigen::MatrixXd rows_of(std::size_t block, const std::vector<int>& equations,
                          const Eigen::MatrixXd& jacobian) const;
  double distance_from_tangency(std::size_t block, const Eigen::MatrixXd& jacobian) const;
  bool is_due(std::size_t block, const Eigen::MatrixXd& jacobian, double alpha) const;
  Choice choice(std::size_t block, const Eigen::MatrixXd& jacobian, double alpha) const;
  void count();

  std::vector<PlanBlock> blocks_;
  std::vector<Choice> choices_;
  std::vector<int> removed_;
  int driving_parameters_ = 0;
  int sign_ = 1;
};

}  // namespace gcs
