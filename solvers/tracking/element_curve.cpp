#include "solvers/tracking/element_curve.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>

namespace gcs {
namespace {

/// Without swapping, no step ends this close to a tangency: see plan_curve.cpp.
constexpr double nearest_tangency = 1e-3;

}  // namespace

ElementCurve::ElementCurve(GeneralFamily family, std::vector<PlanBlock> blocks,
                           const ElementCurveOptions& options)
    : family_(std::move(family)),
      options_(options),
      plan_(std::move(blocks)),
      y_(coordinates()),
      jacobian_(family_.unknowns(), coordinates()),
      sums_(family_.unknowns()) {}

void ElementCurve::differentiate() {
  ++work_.jacobians;
  family_.jacobian(y_, jacobian_);
}

/// Minus what the removed equations are short of: what is asked of them less what a change gives.
Eigen::VectorXd ElementCurve::of_removed(const Eigen::VectorXd& per_equation,
                                         const Eigen::VectorXd& change) const {
  const std::vector<int>& removed = plan_.removed();
  return per_equation(removed) - jacobian_(removed, Eigen::all) * change;
}

/// Derivatives of everything by t and the driving parameters, and with them those of the removed equations.
void ElementCurve::linearise() {
  plan_.linearise(jacobian_);
  const int d = plan_.driving_parameters();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(sums_.size());
  sensitivity_.setZero(coordinates(), d + 1);
  bordered_.resize(d + 1, d + 1);
  Eigen::VectorXd change(coordinates());
  for (int j = 0; j <= d; ++j) {
    const Eigen::VectorXd parameters = Eigen::VectorXd::Unit(d + 1, j);
    change[family_.unknowns()] = parameters[0];
    plan_.solve(jacobian_, none, parameters.tail(d), change);
    sensitivity_.col(j) = change;
    bordered_.col(j).head(d) = -of_removed(none, change);
  }
}

void ElementCurve::border_and_invert(const Eigen::VectorXd& tangent) {
  bordered_.bottomRows<1>() = tangent.transpose() * sensitivity_;
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(bordered_);
  bordered_inverse_ = lu.inverse();
  ++work_.factorisations;
  side_ = determinant_sign(lu) * plan_.sign();
}

/// Chooses the plan anew where it is due. False where the plan before sees the figure on another arc.
bool ElementCurve::maintain(const Eigen::VectorXd& tangent) {
  differentiate();
  linearise();
  border_and_invert(tangent);
  if (side_ != accepted_side_) return false;
  if (!options_.swap) return plan_.distance_from_tangency(jacobian_) >= nearest_tangency;
  if (!plan_.is_due(jacobian_, options_.alpha)) return true;
  previous_plan_ = plan_;
  ++work_.plan_changes;
  plan_.choose(jacobian_, options_.alpha);
  linearise();
  border_and_invert(tangent);
  return true;
}

void ElementCurve::residual(bool is_wide) {
  if (is_wide)
    family_.wide_residual(y_, sums_);
  else
    family_.residual(y_, sums_);
}

/// Puts y_ where the plan has it at t and the driving parameters.
bool ElementCurve::evaluate(CorrectorTest& test) {
  Eigen::VectorXd change = Eigen::VectorXd::Zero(coordinates());
  for (;;) {
    ++work_.evaluations;
    residual(test.is_wide());
    plan_.solve(jacobian_, sums_, plan_.driven(y_) - driven_, change);
    y_ -= change;
    const CorrectorTest::Verdict verdict = test.judge(change.norm(), y_.norm());
    if (verdict == CorrectorTest::Verdict::stalled)
      test.widen();
    else if (verdict != CorrectorTest::Verdict::again)
      return verdict == CorrectorTest::Verdict::settled;
  }
}

double ElementCurve::moved_by_rounding() const {
  const int d = plan_.driving_parameters();
  Eigen::VectorXd rounding(d);
  for (int r = 0; r < d; ++r)
    rounding[r] = rounding_of_equation(r, jacobian_.row(plan_.removed()[static_cast<std::size_t>(r)]).norm(),
                                       y_.norm());
  return (sensitivity_ * (bordered_inverse_.leftCols(d) * rounding)).norm();
}

bool ElementCurve::correct(CorrectorTest& test) {
  const int d = plan_.driving_parameters();
  driven_ = plan_.driven(y_);
  for (bool is_settled = false;;) {
    CorrectorTest of_plan(options_.tolerance, test.is_wide());
    if (!evaluate(of_plan)) return false;
    if (is_settled) return !test.is_wide() || CorrectorTest::are_arcs_apart(moved_by_rounding(), y_.norm());
    residual(test.is_wide());
    const Eigen::VectorXd removed = sums_(plan_.removed());
    const Eigen::VectorXd parameters = bordered_inverse_.leftCols(d) * removed;
    const Eigen::VectorXd change = sensitivity_ * parameters;
    y_ -= change;
    driven_ -= parameters.tail(d);
    ++work_.newton_iterations;
    const CorrectorTest::Verdict verdict = test.judge(change.norm(), y_.norm());
    if (verdict == CorrectorTest::Verdict::refuse) return false;
    if (verdict == CorrectorTest::Verdict::stalled) test.widen();
    is_settled = verdict == CorrectorTest::Verdict::settled;
  }
}

bool ElementCurve::start(int orientation, ArcSeries& series) {
  y_ = family_.start();
  differentiate();
  plan_.choose(jacobian_, options_.alpha);
  linearise();
  const int d = plan_.driving_parameters();
  Eigen::VectorXd direction = Eigen::VectorXd::Unit(1, 0);
  if (d > 0) {
    const Eigen::FullPivLU<Eigen::MatrixXd> full(bordered_.topRows(d));
    ++work_.factorisations;
    if (full.rank() < d) return false;
    direction = full.kernel().col(0);
  }
  Eigen::VectorXd tangent = (sensitivity_ * direction).normalized();
  if (tangent[family_.unknowns()] * orientation < 0) tangent = -tangent;
  border_and_invert(tangent);
  accepted_side_ = side_;
  expand(series);
  return true;
}

bool ElementCurve::advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series,
                           bool is_wide) {
  y_ = y;
  if (!maintain(tangent)) return false;
  CorrectorTest test(options_.tolerance, is_wide);
  if (!correct(test)) return false;
  if (test.matrix_is_stale()) {
    differentiate();
    linearise();
    border_and_invert(tangent);
  }
  if (shortest_length(t()) < 0) return false;
  y = y_;
  expand(series);
  return true;
}

void ElementCurve::renew(ArcSeries& series) {
  y_ = series.coefficient(0);
  differentiate();
  linearise();
  border_and_invert(series.coefficient(1));
  expand(series);
}

void ElementCurve::accept() {
  previous_plan_.reset();
  accepted_side_ = side_;
  const int d = plan_.driving_parameters();
  driving_sum_ += d;
  work_.max_driving_parameters = std::max(work_.max_driving_parameters.value_or(0), d);
  work_.mean_driving_parameters = driving_sum_ / static_cast<double>(work_.iterations + 1);
}

void ElementCurve::reject() {
  if (!previous_plan_) return;
  plan_ = *std::move(previous_plan_);
  previous_plan_.reset();
  --work_.plan_changes;
}

/// Order by order: everything as if the driving parameters and t had no coefficient, then theirs from the removed
/// equations and the arc length.
void ElementCurve::expand(ArcSeries& series) {
  const int d = plan_.driving_parameters();
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(d);
  family_.start_series(t());
  series.coefficient(0) = y_;
  series.coefficient(1) = (sensitivity_ * bordered_inverse_.rightCols<1>()).normalized();
  family_.set(1, series.coefficient(1));
  Eigen::VectorXd right(d + 1), change = Eigen::VectorXd::Zero(coordinates());
  for (int n = 2; n <= series.order(); ++n) {
    family_.known(n, sums_);
    change[family_.unknowns()] = 0;
    plan_.solve(jacobian_, sums_, none, change);
    right.head(d) = of_removed(sums_, change);
    right[d] = series.arc_length_term(n) - series.coefficient(1).dot(change);
    change += sensitivity_ * (bordered_inverse_ * right);
    series.coefficient(n) = change;
    if (n < series.order()) family_.set(n, change);
  }
}

}  // namespace gcs
