#include "solvers/tracking/plan_curve.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <numbers>
#include <utility>

#include "solvers/tracking/corrector.hpp"

namespace gcs {
namespace {

/// Without swapping, a step may pass a boundary configuration but not end this close to one: the derivatives
/// of the plan, and with them the rounding of its series, grow like 1/γ.
constexpr double nearest_boundary = 1e-3;

}  // namespace

PlanCurve::PlanCurve(const Scene& scene, Plan plan, Figure sketch, const PlanCurveOptions& options)
    : dimension_(scene.dimension()),
      point_count_(scene.point_count()),
      coordinates_(static_cast<Eigen::Index>(scene.dimension()) * scene.point_count() + 1),
      options_(options),
      lengths_(scene.length_paths(), options.order),
      edges_(scene.constraint_count(), scene.dimension(), options.order),
      plan_(std::move(plan)),
      sketch_(std::move(sketch)),
      points_(sketch_.points) {
  for (const DistanceConstraint& c : scene.problem().constraints) ends_.push_back(c.between);
  configure();
}

/// Sizes and index tables that follow from the plan.
void PlanCurve::configure() {
  driven_.clear();
  for (const Instruction& instruction : plan_.instructions())
    for (int i = 0; i < instruction.count; ++i)
      if (instruction.spheres[i].is_driven()) driven_.push_back(instruction.place);
  sweep_.configure(plan_, static_cast<int>(ends_.size()));

  const Eigen::Index d = plan_.driving_parameters();
  parameters_.setZero(d + 1);
  residual_.setZero(d);
  right_side_.setZero(d + 1);
  change_.setZero(d + 1);
  bordered_.setZero(d + 1, d + 1);
  bordered_inverse_.setZero(d + 1, d + 1);
  sensitivity_.setZero(coordinates_, d + 1);
  sensitivity_(coordinates_ - 1, 0) = 1;
  edges_.resize(static_cast<Eigen::Index>(ends_.size()) + d);
  constant_.setZero(edges_.edges());
}

Figure PlanCurve::figure(const Eigen::VectorXd& y) const {
  Figure figure = sketch_;
  figure.points.topRows(dimension_) = Eigen::Map<const Eigen::MatrixXd>(y.data(), dimension_, point_count_);
  return figure;
}

void PlanCurve::read_parameters(const Eigen::Matrix3Xd& points, double t) {
  parameters_[0] = t;
  Eigen::Index j = 0;
  for (Instruction& instruction : plan_.instructions()) {
    instruction.side = side_of(instruction, points);
    for (int i = 0; i < instruction.count; ++i)
      if (instruction.spheres[i].is_driven())
        parameters_[++j] =
            (points.col(instruction.place) - instruction.spheres[i].reference).squaredNorm() / 2;
  }
}

bool PlanCurve::evaluate() {
  ++work_.evaluations;
  const auto radius = [this](const PlanSphere& sphere, int j) {
    return sphere.is_driven() ? std::sqrt(2 * parameters_[j + 1])
                              : lengths_.paths()[sphere.constraint].value(parameters_[0]);
  };
  return evaluate_plan(plan_, 0, radius, points_);
}

void PlanCurve::residual(Eigen::Ref<Eigen::VectorXd> f) const {
  for (std::size_t r = 0; r < plan_.removed().size(); ++r) {
    const int c = plan_.removed()[r];
    f[static_cast<Eigen::Index>(r)] = half_excess(points_, ends_[c], lengths_.paths()[c], parameters_[0]);
  }
}

void PlanCurve::wide_residual(Eigen::Ref<Eigen::VectorXd> f) {
  Eigen::Index edge = 0;
  for (; edge < std::ssize(ends_); ++edge)
    constant_[edge] = wide_half_excess(points_, ends_[edge], lengths_.paths()[edge], parameters_[0]);
  Eigen::Index driving = 0;
  for (const Instruction& instruction : plan_.instructions())
    for (int i = 0; i < instruction.count; ++i) {
      const PlanSphere& sphere = instruction.spheres[i];
      if (!sphere.is_driven()) continue;
      const DoubleDouble square =
          squared_distance<Eigen::Vector3d>(points_.col(instruction.place), sphere.reference, 3);
      constant_[edge++] = (square - DoubleDouble{2 * parameters_[++driving]}).value() / 2;
    }
  Eigen::VectorXd move = Eigen::VectorXd::Zero(coordinates_ - 1);
  sweep_.solve(constant_, 0, move.data());
  for (std::size_t r = 0; r < plan_.removed().size(); ++r) {
    const int c = plan_.removed()[r];
    f[static_cast<Eigen::Index>(r)] = constant_[c] - pull(c, move.data());
  }
}

void PlanCurve::differentiate() {
  ++work_.jacobians;
  sweep_.linearise(plan_, points_);
  sensitivity_.topRows(coordinates_ - 1).setZero();
  const Eigen::Index m = static_cast<Eigen::Index>(ends_.size());
  const Eigen::Index d = plan_.driving_parameters();
  constant_.setZero();
  for (Eigen::Index c = 0; c < m; ++c) constant_[c] = slope(static_cast<int>(c));
  sweep_.solve(constant_, 0, sensitivity_.col(0).data());
  constant_.setZero();
  std::size_t first = 0;
  for (Eigen::Index j = 0; j < d; ++j) {
    while (plan_.driven_before(first + 1) <= j) ++first;
    constant_[m + j] = 1;
    sweep_.solve(constant_, first, sensitivity_.col(j + 1).data());
    constant_[m + j] = 0;
  }
  for (Eigen::Index r = 0; r < d; ++r) {
    const int c = plan_.removed()[static_cast<std::size_t>(r)];
    for (Eigen::Index j = 0; j <= d; ++j) bordered_(r, j) = pull(c, sensitivity_.col(j).data());
    bordered_(r, 0) -= slope(c);
  }
}

/// (p_a − p_b)·(move_a − move_b) for the ends of constraint c.
double PlanCurve::pull(int c, const double* move) const {
  const auto [a, b] = ends_[c];
  double sum = 0;
  for (int axis = 0; axis < dimension_; ++axis)
    sum += (points_(axis, a) - points_(axis, b)) * (move[row(a, axis)] - move[row(b, axis)]);
  return sum;
}

/// a_c·a_c'(t) at the current t.
double PlanCurve::slope(int c) const {
  const LengthPath& path = lengths_.paths()[c];
  return path.value(parameters_[0]) * path.slope(parameters_[0]);
}

void PlanCurve::border_and_invert(const Eigen::VectorXd& tangent) {
  bordered_.bottomRows<1>() = tangent.transpose() * sensitivity_;
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(bordered_);
  bordered_inverse_ = lu.inverse();
  ++work_.factorisations;
  side_of_s_ = determinant_sign(lu);
  for (const Instruction& instruction : plan_.instructions()) side_of_s_ *= instruction.side;
}

/// What Algorithm 2 makes of the plan at the figure in points_, where it is due.
std::optional<Plan> PlanCurve::changed_plan() const {
  if (!options_.swap || !needs_change(plan_, options_.exchange, points_)) return std::nullopt;
  Plan plan = plan_;
  if (!change_plan(plan, options_.exchange, points_).is_any()) return std::nullopt;
  return plan;
}

void PlanCurve::take_plan(Plan plan) {
  previous_plan_ = std::exchange(plan_, std::move(plan));
  ++work_.plan_changes;
  configure();
}

/// Applies Algorithm 2 to the figure in points_ where it is due, and reads branch and parameters off it.
/// False where the plan that is left sees the figure on another arc.
bool PlanCurve::maintain(double t, const Eigen::VectorXd& tangent) {
  std::optional<Plan> changed = changed_plan();
  read_parameters(points_, t);
  if (!changed) return true;
  differentiate();
  border_and_invert(tangent);
  if (side_of_s_ != accepted_side_) return false;
  take_plan(std::move(*changed));
  read_parameters(points_, t);
  return true;
}

bool PlanCurve::too_near() const {
  return !options_.swap && boundary_distance(plan_, options_.exchange, points_) < nearest_boundary;
}

/// The plan is new at points().
void PlanCurve::note_plan() { plans_.push_back({Figure{points_, {}}, parameters_[0], plan_.removed()}); }

void PlanCurve::accept() {
  if (previous_plan_) note_plan();
  previous_plan_.reset();
  accepted_side_ = side_of_s_;
  const int d = plan_.driving_parameters();
  driving_sum_ += d;
  work_.max_driving_parameters = std::max(work_.max_driving_parameters.value_or(0), d);
  work_.mean_driving_parameters = driving_sum_ / static_cast<double>(work_.iterations + 1);
}

void PlanCurve::reject() {
  if (!previous_plan_) return;
  plan_ = std::move(*previous_plan_);
  previous_plan_.reset();
  --work_.plan_changes;
  configure();
}

bool PlanCurve::start(int orientation, ArcSeries& series) {
  plans_.push_back({Figure{points_, {}}, 0, plan_.removed()});
  if (std::optional<Plan> changed = changed_plan()) take_plan(std::move(*changed));
  const bool is_changed = previous_plan_.has_value();
  previous_plan_.reset();
  read_parameters(points_, 0);
  if (is_changed) note_plan();
  if (!evaluate()) return false;
  differentiate();
  const Eigen::Index d = plan_.driving_parameters();
  Eigen::VectorXd direction = Eigen::VectorXd::Unit(1, 0);
  if (d > 0) {
    const Eigen::FullPivLU<Eigen::MatrixXd> full(bordered_.topRows(d));
    ++work_.factorisations;
    if (full.rank() < d) return false;
    direction = full.kernel().col(0);
  }
  Eigen::VectorXd tangent = (sensitivity_ * direction).normalized();
  if (tangent[coordinates_ - 1] * orientation < 0) tangent = -tangent;
  border_and_invert(tangent);
  accepted_side_ = side_of_s_;
  Eigen::VectorXd y(coordinates_);
  y << Eigen::Map<const Eigen::VectorXd>(Eigen::MatrixXd(points_.topRows(dimension_)).data(),
                                         coordinates_ - 1),
      0.0;
  expand(y, series);
  return true;
}

double PlanCurve::moved_by_rounding(double size) {
  for (Eigen::Index r = 0; r < residual_.size(); ++r) {
    const int c = plan_.removed()[static_cast<std::size_t>(r)];
    residual_[r] =
        rounding_of_equation(r, std::numbers::sqrt2 * lengths_.paths()[c].value(parameters_[0]), size);
  }
  return (sensitivity_ * (bordered_inverse_.leftCols(residual_.size()) * residual_)).norm();
}

bool PlanCurve::advance(Eigen::VectorXd& y, const Eigen::VectorXd& tangent, ArcSeries& series, bool is_wide) {
  auto figure = Eigen::Map<Eigen::MatrixXd>(y.data(), dimension_, point_count_);
  points_.topRows(dimension_) = figure;
  if (too_near()) return false;
  if (!maintain(y[coordinates_ - 1], tangent)) return false;
  CorrectorTest test(options_.tolerance, is_wide);
  for (bool first = true, settled = false; !settled; first = false) {
    if (!evaluate()) return false;
    if (first) {
      differentiate();
      border_and_invert(tangent);
      if (!previous_plan_ && side_of_s_ != accepted_side_) return false;
    }
    if (test.is_wide())
      wide_residual(residual_);
    else
      residual(residual_);
    change_.noalias() = bordered_inverse_.leftCols(residual_.size()) * residual_;
    parameters_ -= change_;
    move_.noalias() = sensitivity_ * change_;
    ++work_.newton_iterations;
    const CorrectorTest::Verdict verdict = test.judge(move_.norm(), y.norm());
    if (verdict == CorrectorTest::Verdict::refuse) return false;
    if (verdict == CorrectorTest::Verdict::stalled) test.widen();
    settled = verdict == CorrectorTest::Verdict::settled;
  }
  // What the last change leaves out of its derivative is below the rounding, as the iteration would go on to show.
  points_.topRows(dimension_) -= Eigen::Map<const Eigen::MatrixXd>(move_.data(), dimension_, point_count_);
  if (test.is_wide() && !CorrectorTest::are_arcs_apart(moved_by_rounding(y.norm()), y.norm())) return false;
  if (test.matrix_is_stale()) {
    differentiate();
    border_and_invert(tangent);
  }
  if (shortest_length(parameters_[0]) < 0) return false;
  figure = points_.topRows(dimension_);
  y[coordinates_ - 1] = parameters_[0];
  expand(y, series);
  return true;
}

void PlanCurve::renew(ArcSeries& series) {
  const Eigen::VectorXd y = series.coefficient(0);
  differentiate();
  border_and_invert(series.coefficient(1));
  expand(y, series);
}

void PlanCurve::set_differences(int n, const ArcSeries& series) {
  const double* coefficient = series.coefficients().col(n).data();
  lengths_.set(n, coefficient[coordinates_ - 1]);
  auto difference = edges_.difference(n);
  Eigen::Index i = 0;
  for (int axis = 0; axis < dimension_; ++axis) {
    for (const auto& [a, b] : ends_) difference[i++] = coefficient[row(a, axis)] - coefficient[row(b, axis)];
    for (int point : driven_) difference[i++] = coefficient[row(point, axis)];
  }
}

/// The n-th coefficients of all points as if the parameters had none, then the parameters' from the removed
/// constraints. constant_ holds what lower orders contribute to each edge.
void PlanCurve::solve_order(int n, ArcSeries& series) {
  auto column = series.coefficient(n);
  column.setZero();
  sweep_.solve(constant_, 0, column.data());
  const Eigen::Index d = plan_.driving_parameters();
  for (Eigen::Index r = 0; r < d; ++r) {
    const int c = plan_.removed()[static_cast<std::size_t>(r)];
    right_side_[r] = constant_[c] - pull(c, column.data());
  }
  right_side_[d] = series.arc_length_term(n) - series.coefficient(1).dot(column);
  change_ = bordered_inverse_.lazyProduct(right_side_);
  for (Eigen::Index j = 0; j <= d; ++j) column += change_[j] * sensitivity_.col(j);
}

void PlanCurve::expand(const Eigen::VectorXd& y, ArcSeries& series) {
  lengths_.start(y[coordinates_ - 1]);
  series.coefficient(0) = y;
  series.coefficient(1).noalias() = sensitivity_ * bordered_inverse_.rightCols<1>();
  series.coefficient(1) /= series.coefficient(1).norm();
  set_differences(1, series);
  for (int n = 2; n <= series.order(); ++n) {
    lengths_.known(n, constant_.head(static_cast<Eigen::Index>(ends_.size())));
    constant_.tail(plan_.driving_parameters()).setZero();
    edges_.subtract_half_convolution(n, constant_);
    solve_order(n, series);
    if (n < series.order()) set_differences(n, series);
  }
}

}  // namespace gcs
