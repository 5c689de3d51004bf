#pragma once
/// S in the driving parameters of a construction plan and t, R^d × R, as the series tracker wants it ([I] §3,
/// §4).
///
/// The unknowns are t and κ_j = k_j²/2 for the d driving parameters: half squares enter every equation
/// linearly. Everything else follows from them through the plan, which is evaluated instruction by
/// instruction: points, their derivatives by the parameters, and their Taylor coefficients. The only larger
/// system than those of construction/plan_sweep.hpp is the (d+1)×(d+1) one of the removed constraints.
///
/// The coordinates seen by the tracker are those of the figure and t, in the plan's own frame. Arc length is
/// measured on the figure, so that the series converges as far as that of S itself and not only as far as
/// that of the reduced path, which bends sharply near boundary configurations.

#include "solvers/construction/exchange.hpp"
#include "solvers/construction/plan_sweep.hpp"
#include "solvers/construction/plan_use.hpp"
#include "solvers/running/work.hpp"
#include "solvers/tracking/arc_series.hpp"
#include "solvers/tracking/edge_series.hpp"

namespace gcs {

struct PlanCurveOptions {
  int order = 12;
  double tolerance = 1e-7;
  bool swap = true;  ///< Algorithms 2–4; false: only the branch is found again after every step
  ExchangeRule exchange;
};

class PlanCurve {
 public:
  /// `plan` and `sketch` belong together: the figure is in the plan's frame.
  PlanCurve(const Scene& scene, Plan plan, Figure sketch, const PlanCurveOptions& options);

  Eigen::Index coordinates() const { return coordinates_; }
  bool start(int orientation, ArcSeries& series);
  bool advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series, bool is_wide);
  void renew(ArcSeries& series);
  double shortest_length(double t) const { return lengths_.shortest(t); }
  void accept();
  void reject();
  WorkCounters& work() { return work_; }

  const Plan& plan() const { return plan_; }
  /// The plans of the accepted points, as in PathRecord.
  const std::vector<PlanUse>& plans() const { return plans_; }
  /// The figure of a tracker's point, in the plan's frame.
  Figure figure(const Eigen::VectorXd& y) const;

  /// Evaluates the plan at the current parameters into points(); false outside its domain.
  bool evaluate();
  /// Parameters and branch of the plan at a figure and t.
  void read_parameters(const Eigen::Matrix3Xd& points, double t);
  /// (|p_a − p_b|² − a²)/2 of every removed constraint, at points().
  void residual(Eigen::Ref<Eigen::VectorXd> f) const;
  /// The same in double-double, and of the points that the plan has without rounding, to first order: less what the
  /// removed constraints change by when the points move to where the others hold. Precondition: differentiate() was called
  /// near by.
  void wide_residual(Eigen::Ref<Eigen::VectorXd> f);
  /// Derivatives of all points by (t, κ_1, …, κ_d), and the Jacobian of the removed constraints into the
  /// bordered matrix.
  void differentiate();
  const Eigen::Matrix3Xd& points() const { return points_; }
  /// Unknowns in the order (t, κ_1, …, κ_d).
  Eigen::VectorXd& parameters() { return parameters_; }
  /// Row (dimension·point + axis) is the derivative of that coordinate; the last row is that of t.
  const auto& sensitivity() const { return sensitivity_; }
  auto reduced_jacobian() const { return bordered_.topRows(plan_.driving_parameters()); }

 private:
  void configure();
  std::optional<Plan> changed_plan() const;
  void take_plan(Plan plan);
  bool maintain(double t, const Eigen::VectorXd& tangent);
  void note_plan();
  bool too_near() const;
  void border_and_invert(const Eigen::VectorXd& tangent);
  void expand(const Eigen::VectorXd& y, ArcSeries& series);
  void set_differences(int n, const ArcSeries& series);
  void solve_order(int n, ArcSeries& series);
  double moved_by_rounding(double size);
  double pull(int c, const double* move) const;
  double slope(int c) const;
  Eigen::Index row(int point, int axis) const { return static_cast<Eigen::Index>(dimension_) * point + axis; }

  int dimension_;
  int point_count_;
  Eigen::Index coordinates_;
  PlanCurveOptions options_;
  std::vector<std::array<int, 2>> ends_;  ///< of every constraint
  LengthSeries lengths_;
  EdgeSeries edges_;         ///< constraints, then driven spheres
  std::vector<int> driven_;  ///< the point that the sphere of each driving parameter places
  Plan plan_;
  std::optional<Plan> previous_plan_;  ///< what reject() goes back to
  std::vector<PlanUse> plans_;
  Figure sketch_;

  Eigen::Matrix3Xd points_;
  Eigen::VectorXd parameters_;
  PlanSweep sweep_;
  Eigen::MatrixXd sensitivity_;
  Eigen::MatrixXd bordered_, bordered_inverse_;
  /// The sign of the determinant of [f_X, f_t; tangent] in all coordinates, as the plan orders them. It
  /// changes with the plan, and otherwise not on S.
  int side_of_s_ = 0;
  int accepted_side_ = 0;  ///< at the last accepted point
  Eigen::VectorXd right_side_, change_, residual_;
  Eigen::VectorXd move_;      ///< of all coordinates and t by the last change
  Eigen::VectorXd constant_;  ///< per edge
  WorkCounters work_;
  double driving_sum_ = 0;
};

}  // namespace gcs
