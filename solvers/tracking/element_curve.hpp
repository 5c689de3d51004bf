#pragma once
/// S of a general scene in the driving parameters of a construction plan and t, R^d × R, as the series tracker wants it:
/// what plan_curve.hpp is for points and distances, for points, lines and planes with whatever is stated between them.
///
/// The unknowns are t and the d driving parameters. All others follow from them through the plan, block by block
/// (construction/plan_blocks.hpp): a block is solved by Newton's method from where its element was, which keeps to the
/// branch of the instruction that the figure is on. The only larger system is the (d+1)×(d+1) one of the removed
/// equations. The coordinates seen by the tracker are all unknowns and t, as for plan_curve.hpp.

#include <optional>
#include <vector>

#include "solvers/construction/plan_blocks.hpp"
#include "solvers/tracking/corrector.hpp"
#include "solvers/tracking/general_curve.hpp"

namespace gcs {

struct ElementCurveOptions {
  double tolerance = 1e-7;
  bool swap = true;  ///< false: the first plan is kept
  double alpha = 0.1;
};

class ElementCurve {
 public:
  /// `blocks`: of the system that the family is of.
  ElementCurve(GeneralFamily family, std::vector<PlanBlock> blocks, const ElementCurveOptions& options);

  Eigen::Index coordinates() const { return family_.unknowns() + 1; }
  bool start(int orientation, ArcSeries& series);
  bool advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series, bool is_wide);
  void renew(ArcSeries& series);
  double shortest_length(double t) const { return family_.shortest_length(t); }
  void accept();
  void reject();
  WorkCounters& work() { return work_; }
  Eigen::VectorXd signs_towards(const Eigen::VectorXd& y0, const Eigen::VectorXd& y) const {
    return family_.signs_towards(y0, y);
  }

 private:
  double& t() { return y_[family_.unknowns()]; }
  void differentiate();
  void linearise();
  void border_and_invert(const Eigen::VectorXd& tangent);
  bool maintain(const Eigen::VectorXd& tangent);
  /// Into sums_.
  void residual(bool is_wide);
  bool evaluate(CorrectorTest& test);
  double moved_by_rounding() const;
  bool correct(CorrectorTest& test);
  Eigen::VectorXd of_removed(const Eigen::VectorXd& per_equation, const Eigen::VectorXd& change) const;
  void expand(ArcSeries& series);

  GeneralFamily family_;
  ElementCurveOptions options_;
  BlockPlan plan_;
  std::optional<BlockPlan> previous_plan_;  ///< what reject() goes back to
  Eigen::VectorXd y_;                       ///< all unknowns, then t
  Eigen::VectorXd driven_;                  ///< the driving parameters that y_ is to have
  Eigen::MatrixXd jacobian_;
  Eigen::MatrixXd sensitivity_;  ///< of y_ by t and the driving parameters
  Eigen::MatrixXd bordered_, bordered_inverse_;
  Eigen::VectorXd sums_;              ///< per equation
  int side_ = 0, accepted_side_ = 0;  ///< as of PlanCurve
  WorkCounters work_;
  double driving_sum_ = 0;
};

}  // namespace gcs
