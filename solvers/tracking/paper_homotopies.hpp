#pragma once
/// The two homotopies of [I] as published, in the file's unit and with unsquared distances: H of §2.2 in all
/// coordinates, and H_R of §3.2 in the driving parameters of a plan. Both differentiate numerically.

#include "solvers/construction/exchange.hpp"
#include "solvers/construction/plan_use.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/tracking/euler_newton_tracker.hpp"

namespace gcs {

/// H(X, t) = |p_j − p_k| − a_i(t) in R^m × R.
class PaperDistanceHomotopy {
 public:
  explicit PaperDistanceHomotopy(const Scene& scene);

  Eigen::VectorXd start() const;
  bool residual(const Eigen::VectorXd& y, Eigen::VectorXd& f);
  bool jacobian(const Eigen::VectorXd& y, const Eigen::VectorXd& f, Eigen::MatrixXd& jacobian);
  Eigen::VectorXd figure_coordinates(const Eigen::VectorXd& y) const { return y; }
  bool after_step(const Eigen::VectorXd&, Eigen::VectorXd&, Eigen::VectorXd&) { return false; }
  std::string undefined() const { return ""; }
  std::string configuration(const Eigen::VectorXd&) const { return ""; }
  bool try_other_branch(const Eigen::VectorXd&) { return false; }
  void take_back_branch() {}
  WorkCounters& work() { return work_; }
  /// The figure, in the scene's unit, of coordinates that figure_coordinates gave.
  Figure figure(const Eigen::VectorXd& coordinates) const;

 private:
  double unit_;  ///< the scene's unit in the file's
  DistanceSystem system_;
  std::vector<LengthPath> lengths_;  ///< in the scene's unit
  Figure sketch_;
  Eigen::Matrix3Xd points_;
  Eigen::VectorXd shifted_, shifted_residual_;
  WorkCounters work_;
};

/// How PaperPlanHomotopy deviates from the published one.
struct PlanHomotopyOptions {
  ExchangeRule rule;
  /// The tangent is carried over a change of the plan by the derivative of ϕ'∘ϕ, as printed; false: by ϕ'∘ϕ
  /// at both ends of the last step, since ϕ's derivative is worst just where the plan has to be changed.
  bool turns_as_printed = false;
  /// False: instead of changing the plan, a failed correction within α of a boundary configuration is tried
  /// again on the other branch of the nearest instruction.
  bool swap = true;
  /// Whether a derivative re-evaluates the plan from the instruction that introduces the parameter (§7.2)
  /// or, with the same bits, the whole.
  bool partial = true;
};

/// [b]H_R(A+, t) in R^d × R, with the plan changed by Algorithm 2 after a step (§4), the direction carried
/// over by ϕ'∘ϕ (§7.1), and derivatives by re-evaluating the plan (§7.2).
class PaperPlanHomotopy {
 public:
  /// `plan` and `sketch` in the plan's frame and the scene's unit.
  PaperPlanHomotopy(const Scene& scene, Plan plan, const Figure& sketch, const PlanHomotopyOptions& options);

  Eigen::VectorXd start();
  bool residual(const Eigen::VectorXd& y, Eigen::VectorXd& f);
  bool jacobian(const Eigen::VectorXd& y, const Eigen::VectorXd& f, Eigen::MatrixXd& jacobian);
  Eigen::VectorXd figure_coordinates(const Eigen::VectorXd& y);
  bool after_step(const Eigen::VectorXd& before, Eigen::VectorXd& y, Eigen::VectorXd& tangent);
  const std::string& undefined() const { return undefined_; }
  /// The instruction nearest to a boundary configuration, and the one whose spheres meet at the smallest angle.
  std::string configuration(const Eigen::VectorXd& y);
  bool try_other_branch(const Eigen::VectorXd& y);
  void take_back_branch();
  WorkCounters& work() { return work_; }
  /// The plans of the accepted points, as in PathRecord.
  const std::vector<PlanUse>& plans() const { return plans_; }
  /// All that Algorithm 2 did.
  const PlanChange& changes() const { return changes_; }
  Figure figure(const Eigen::VectorXd& coordinates) const;

 private:
  /// Algorithm 2 at points_ where it is due; true if the plan is another one now.
  bool change(double t);
  /// A figure just before `y` on the path.
  bool place_before(const Eigen::VectorXd& before, const Eigen::VectorXd& y, const Eigen::VectorXd& tangent,
                    double& t);
  bool evaluate(const Eigen::VectorXd& y, std::size_t first, Eigen::Matrix3Xd& points);
  void removed_residual(const Eigen::Matrix3Xd& points, double t, Eigen::VectorXd& f) const;
  /// ϕ': the driving parameters and t of a figure.
  Eigen::VectorXd parameters(const Eigen::Matrix3Xd& points, double t) const;
  void find_branch(const Eigen::Matrix3Xd& points);
  void note_plan(const Eigen::Matrix3Xd& points, double t);

  const Scene& scene_;
  double unit_;
  int dimension_;
  std::vector<std::array<int, 2>> ends_;
  std::vector<LengthPath> lengths_;
  Plan plan_;
  PlanHomotopyOptions options_;
  Eigen::Matrix3Xd sketch_, points_, shifted_points_;
  Eigen::VectorXd shifted_residual_;
  std::size_t flipped_ = 0;  ///< the instruction whose branch was changed last
  WorkCounters work_;
  double driving_sum_ = 0;
  std::vector<PlanUse> plans_;
  PlanChange changes_;
  std::string undefined_;
};

}  // namespace gcs
