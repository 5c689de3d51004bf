#pragma once
/// The tracker of [I] §7.1 to the letter: Euler predictor with step δ in [δmin, δmax], Newton corrector, δ
/// doubled after a success where 2δ ≤ δmax and halved after a failure, Jacobians by finite differences.
///
/// What [I] leaves open: the first step is δmax; a correction is at most 10 Newton iterations in the
/// hyperplane through the predicted point normal to the tangent and succeeds with the first of 2-norm below
/// 1e-10; lengths are in the file's unit; a crossing of t = 1 is a change of sign of t − 1 between accepted
/// points; the path is closed when it passes the start in the direction of the first tangent. The step that
/// does so is counted; a tangent makes an acute angle with the one before.
///
/// It does not avoid jumps between arcs, as [I] says itself; the mode exists to reproduce the published
/// figures.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <concepts>
#include <utility>

#include "solvers/tracking/tracked_path.hpp"

namespace gcs {

/// A homotopy R^n × R → R^n whose last coordinate is t.
template <class H>
concept Homotopy = requires(H homotopy, const Eigen::VectorXd& y, Eigen::VectorXd& out,
                            Eigen::MatrixXd& jacobian, Eigen::VectorXd& point, Eigen::VectorXd& tangent) {
  { homotopy.start() } -> std::same_as<Eigen::VectorXd>;
  /// H(y); false outside its domain.
  { homotopy.residual(y, out) } -> std::same_as<bool>;
  /// The n × (n+1) Jacobian by finite differences, given H(y) in `out`.
  { homotopy.jacobian(y, out, jacobian) } -> std::same_as<bool>;
  /// Coordinates that do not depend on how the homotopy is written (the figure and t), for closing and
  /// results.
  { homotopy.figure_coordinates(y) } -> std::same_as<Eigen::VectorXd>;
  /// Called after every accepted step from y to `point`, where the path has this tangent; true if it rewrote
  /// the homotopy, with `point` and `tangent` in the new coordinates.
  { homotopy.after_step(y, point, tangent) } -> std::same_as<bool>;
  /// Why it could not be rewritten as it should, which ends the path; empty: it could.
  { homotopy.undefined() } -> std::convertible_to<std::string>;
  /// What is peculiar about the figure at y, for a path that gets stuck there; empty: nothing.
  { homotopy.configuration(y) } -> std::convertible_to<std::string>;
  /// Called when a correction failed: true if another branch of the homotopy may be tried from y; called
  /// again with the outcome false to take it back.
  { homotopy.try_other_branch(y) } -> std::same_as<bool>;
  homotopy.take_back_branch();
  { homotopy.work() } -> std::same_as<WorkCounters&>;
};

struct EulerNewtonOptions {
  double step_max = 0.1;
  std::int64_t max_steps = 1'000'000;
  int orientation = 1;
  bool stops_at_first = false;  ///< at the first solution
  TimeRange far{};              ///< S is given up beyond it
  bool keep_points = false;     ///< in TrackedPath::points, as figure_coordinates
};

template <Homotopy H>
class EulerNewtonTracker {
 public:
  EulerNewtonTracker(H& homotopy, const EulerNewtonOptions& options, const TrackerContext& context)
      : homotopy_(homotopy), options_(options), context_(context), step_(options.step_max) {}

  TrackedPath run() {
    here_ = homotopy_.start();
    if (const std::string cause = homotopy_.undefined(); !cause.empty())
      return finish(TrackedPath::End::failed, cause);
    if (!first_tangent())
      return finish(TrackedPath::End::failed,
                    "the Jacobian is singular at the sketch: hypothesis (h1) fails there");
    start_ = homotopy_.figure_coordinates(here_);
    start_tangent_ = figure_direction(here_, tangent_);
    if (options_.keep_points) path_.points.push_back(start_);
    while (homotopy_.work().iterations < options_.max_steps) {
      if (context_.stop.stop_requested()) return finish(TrackedPath::End::stopped, "stopped on request");
      if (!step())
        return finish(TrackedPath::End::failed, step_too_small(t_of(here_)) + homotopy_.configuration(here_));
      const bool closed = closes();
      record_crossing();
      path_.length += (there_ - here_).norm();
      if (options_.keep_points) path_.points.push_back(homotopy_.figure_coordinates(there_));
      if (closed) return finish(TrackedPath::End::closed, "");
      if (options_.stops_at_first && !path_.crossings.empty()) return finish(TrackedPath::End::reached, "");
      if (auto cause = runs_off(options_.far, t_of(there_)))
        return finish(TrackedPath::End::failed, *std::move(cause));
      previous_ = std::exchange(here_, there_);
      if (!next_tangent()) return finish(TrackedPath::End::failed, no_tangent());
      if (context_.monitor && homotopy_.work().iterations % 256 == 0)
        context_.monitor->progress("tracking S", -1);
    }
    return finish(TrackedPath::End::failed,
                  "max_steps reached before the path closed" + homotopy_.configuration(here_));
  }

 private:
  static constexpr int max_newton = 10;
  static constexpr double newton_tolerance = 1e-10;
  static constexpr double closing_distance = 1e-6;  ///< relative to the size of (X, t)

  static double t_of(const Eigen::VectorXd& y) { return y[y.size() - 1]; }

  bool evaluate_jacobian(const Eigen::VectorXd& y) {
    residual_.resize(y.size() - 1);
    jacobian_.resize(y.size() - 1, y.size());
    return homotopy_.residual(y, residual_) && homotopy_.jacobian(y, residual_, jacobian_);
  }

  /// B = [jacobian; last_row]
  Eigen::PartialPivLU<Eigen::MatrixXd> bordered(const Eigen::VectorXd& last_row) {
    Eigen::MatrixXd matrix(jacobian_.cols(), jacobian_.cols());
    matrix.topRows(jacobian_.rows()) = jacobian_;
    matrix.bottomRows<1>() = last_row.transpose();
    ++homotopy_.work().factorisations;
    return matrix.partialPivLu();
  }

  bool first_tangent() {
    if (!evaluate_jacobian(here_)) return false;
    if (jacobian_.rows() == 0) {
      tangent_ = Eigen::VectorXd::Constant(1, options_.orientation);
      return true;
    }
    const Eigen::FullPivLU<Eigen::MatrixXd> full(jacobian_);
    if (full.rank() < jacobian_.rows()) return false;
    tangent_ = full.kernel().col(0).normalized();
    if (t_of(tangent_) * options_.orientation < 0) tangent_ = -tangent_;
    return true;
  }

  bool next_tangent() {
    if (!continued_tangent()) return false;
    const bool is_rewritten = homotopy_.after_step(previous_, here_, tangent_);
    return homotopy_.undefined().empty() && (!is_rewritten || continued_tangent());
  }

  std::string no_tangent() {
    const std::string cause = homotopy_.undefined();
    return cause.empty() ? "the Jacobian is singular near t = " + std::to_string(t_of(here_)) : cause;
  }

  /// The tangent at here_ that makes an acute angle with the last one.
  bool continued_tangent() {
    if (!evaluate_jacobian(here_)) return false;
    const Eigen::Index last = tangent_.size() - 1;
    tangent_ = bordered(tangent_).solve(Eigen::VectorXd::Unit(last + 1, last)).normalized();
    return tangent_.allFinite();
  }

  bool step() {
    WorkCounters& work = homotopy_.work();
    while (true) {
      if (correct(here_ + step_ * tangent_, tangent_) || on_other_branch()) break;
      ++work.rejected_steps;
      if (step_ < 2 * least_step) return false;
      step_ /= 2;
    }
    ++work.iterations;
    work.smallest_step = std::min(work.smallest_step.value_or(step_), step_);
    if (2 * step_ <= options_.step_max) step_ *= 2;
    return true;
  }

  bool on_other_branch() {
    if (!homotopy_.try_other_branch(here_)) return false;
    if (correct(here_ + step_ * tangent_, tangent_)) return true;
    homotopy_.take_back_branch();
    return false;
  }

  /// Newton from `y` in the hyperplane through it normal to `normal`; the result is there_.
  bool correct(Eigen::VectorXd y, const Eigen::VectorXd& normal) {
    for (int i = 0; i < max_newton; ++i) {
      if (!evaluate_jacobian(y)) return false;
      Eigen::VectorXd right = Eigen::VectorXd::Zero(y.size());
      right.head(residual_.size()) = residual_;
      const Eigen::VectorXd correction = bordered(normal).solve(right);
      y -= correction;
      ++homotopy_.work().newton_iterations;
      const double size = correction.norm();
      if (!std::isfinite(size)) return false;
      if (size < newton_tolerance) {
        there_ = y;
        return true;
      }
    }
    return false;
  }

  Eigen::VectorXd figure_direction(const Eigen::VectorXd& y, const Eigen::VectorXd& direction) {
    const double epsilon = 1e-6;
    return (homotopy_.figure_coordinates(y + epsilon * direction) - homotopy_.figure_coordinates(y))
        .normalized();
  }

  /// The point of the path between here_ and there_ at which `value`, of opposite signs there, vanishes (to
  /// 1e-9).
  template <class Value>
  Eigen::VectorXd locate(const Value& value) {
    const Eigen::VectorXd end = there_;
    const Eigen::VectorXd chord = end - here_;
    const Eigen::VectorXd normal = chord.normalized();
    double low = 0;
    double high = 1;
    const bool rising = value(end) > 0;
    Eigen::VectorXd point = end;
    for (int i = 0; i < 60 && high - low > 1e-12; ++i) {
      const double middle = (low + high) / 2;
      point = here_ + middle * chord;
      if (correct(point, normal)) point = there_;
      const double v = value(point);
      if (std::abs(v) < 1e-10) break;
      ((v > 0) == rising ? high : low) = middle;
    }
    there_ = end;
    return point;
  }

  bool closes() {
    const auto offset = [this](const Eigen::VectorXd& y) {
      return start_tangent_.dot(homotopy_.figure_coordinates(y) - start_);
    };
    if (homotopy_.work().iterations == 1) return false;
    const Eigen::VectorXd before = homotopy_.figure_coordinates(here_);
    const Eigen::VectorXd after = homotopy_.figure_coordinates(there_);
    const double reach = 2 * (after - before).norm();
    if ((before - start_).norm() > reach || !(offset(here_) < 0 && offset(there_) >= 0)) return false;
    const Eigen::VectorXd point = locate(offset);
    if ((homotopy_.figure_coordinates(point) - start_).norm() > closing_distance * (1 + start_.norm()))
      return false;
    there_ = point;
    return true;
  }

  void record_crossing() {
    const bool before = t_of(here_) >= 1;
    const bool after = t_of(there_) >= 1;
    if (before == after) return;
    const Eigen::VectorXd point = locate([](const Eigen::VectorXd& y) { return t_of(y) - 1; });
    path_.crossings.push_back({homotopy_.figure_coordinates(point), after ? 1 : -1});
  }

  TrackedPath finish(TrackedPath::End end, std::string cause) {
    path_.end = end;
    path_.cause = std::move(cause);
    path_.work = homotopy_.work();
    return std::move(path_);
  }

  H& homotopy_;
  EulerNewtonOptions options_;
  TrackerContext context_;
  double step_;
  Eigen::VectorXd previous_, here_, there_, tangent_, start_, start_tangent_, residual_;
  Eigen::MatrixXd jacobian_;
  TrackedPath path_;
};

/// Step of a forward difference in one coordinate: the square root of the rounding unit balances truncation
/// and rounding.
inline double difference_step(double coordinate) { return 1.5e-8 * std::max(1.0, std::abs(coordinate)); }

}  // namespace gcs
