#include "solvers/tracking/paper_homotopies.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace gcs {

PaperDistanceHomotopy::PaperDistanceHomotopy(const Scene& scene)
    : unit_(std::ldexp(1.0, scene.unit_exponent())),
      system_(scene),
      lengths_(scene.length_paths()),
      sketch_(*scene.sketch()),
      points_(unit_ * sketch_.points) {}

Eigen::VectorXd PaperDistanceHomotopy::start() const {
  Eigen::VectorXd y(system_.unknowns() + 1);
  y << unit_ * system_.coordinates(sketch_), 0.0;
  return y;
}

bool PaperDistanceHomotopy::residual(const Eigen::VectorXd& y, Eigen::VectorXd& f) {
  ++work_.evaluations;
  const double t = y[system_.unknowns()];
  system_.place(y.head(system_.unknowns()), points_);
  for (int e = 0; e < system_.equations(); ++e) {
    const auto [a, b] = system_.edges()[e];
    f[e] = (points_.col(a) - points_.col(b)).norm() - unit_ * lengths_[e].value(t);
  }
  return true;
}

bool PaperDistanceHomotopy::jacobian(const Eigen::VectorXd& y, const Eigen::VectorXd& f,
                                     Eigen::MatrixXd& jacobian) {
  ++work_.jacobians;
  shifted_ = y;
  shifted_residual_.resize(f.size());
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    shifted_[i] = y[i] + difference_step(y[i]);
    residual(shifted_, shifted_residual_);
    jacobian.col(i) = (shifted_residual_ - f) / (shifted_[i] - y[i]);
    shifted_[i] = y[i];
  }
  return true;
}

Figure PaperDistanceHomotopy::figure(const Eigen::VectorXd& coordinates) const {
  return system_.figure(coordinates.head(system_.unknowns()) / unit_);
}

PaperPlanHomotopy::PaperPlanHomotopy(const Scene& scene, Plan plan, const Figure& sketch,
                                     const PlanHomotopyOptions& options)
    : scene_(scene),
      unit_(std::ldexp(1.0, scene.unit_exponent())),
      dimension_(scene.dimension()),
      lengths_(scene.length_paths()),
      plan_(std::move(plan)),
      options_(options),
      sketch_(unit_ * sketch.points),
      points_(sketch_),
      shifted_points_(sketch_) {
  for (const DistanceConstraint& c : scene.problem().constraints) ends_.push_back(c.between);
  for (Instruction& instruction : plan_.instructions())
    for (PlanSphere& sphere : instruction.spheres) sphere.reference *= unit_;
}

void PaperPlanHomotopy::find_branch(const Eigen::Matrix3Xd& points) {
  for (Instruction& instruction : plan_.instructions()) instruction.side = side_of(instruction, points);
}

void PaperPlanHomotopy::note_plan(const Eigen::Matrix3Xd& points, double t) {
  plans_.push_back({Figure{points / unit_, {}}, t, plan_.removed()});
}

Eigen::VectorXd PaperPlanHomotopy::parameters(const Eigen::Matrix3Xd& points, double t) const {
  Eigen::VectorXd y(plan_.driving_parameters() + 1);
  Eigen::Index j = 0;
  for (const Instruction& instruction : plan_.instructions())
    for (int i = 0; i < instruction.count; ++i)
      if (instruction.spheres[i].is_driven())
        y[j++] = (points.col(instruction.place) - instruction.spheres[i].reference).norm();
  y[j] = t;
  return y;
}

Eigen::VectorXd PaperPlanHomotopy::start() {
  note_plan(sketch_, 0);
  points_ = sketch_;
  change(0);
  find_branch(sketch_);
  return parameters(sketch_, 0);
}

bool PaperPlanHomotopy::change(double t) {
  if (!options_.swap || !needs_change(plan_, options_.rule, points_)) return false;
  const PlanChange change = change_plan(plan_, options_.rule, points_);
  changes_.exchanges += change.exchanges;
  changes_.restorations += change.restorations;
  changes_.shifts += change.shifts;
  changes_.shifts_in_vain += change.shifts_in_vain;
  if (change.undefined)
    undefined_ = fmt::format("{} (placing {} near t = {:.6g})", change.undefined->why,
                             scene_.problem().name(change.undefined->place), t);
  if (!change.is_any()) return false;
  ++work_.plan_changes;
  note_plan(points_, t);
  return true;
}

bool PaperPlanHomotopy::evaluate(const Eigen::VectorXd& y, std::size_t first, Eigen::Matrix3Xd& points) {
  ++(first == 0 ? work_.evaluations : work_.partial_evaluations);
  const double t = y[y.size() - 1];
  const auto radius = [&](const PlanSphere& sphere, int j) {
    return sphere.is_driven() ? y[j] : unit_ * lengths_[sphere.constraint].value(t);
  };
  return evaluate_plan(plan_, first, radius, points);
}

void PaperPlanHomotopy::removed_residual(const Eigen::Matrix3Xd& points, double t, Eigen::VectorXd& f) const {
  for (std::size_t r = 0; r < plan_.removed().size(); ++r) {
    const int c = plan_.removed()[r];
    const auto [a, b] = ends_[c];
    f[static_cast<Eigen::Index>(r)] = (points.col(a) - points.col(b)).norm() - unit_ * lengths_[c].value(t);
  }
}

bool PaperPlanHomotopy::residual(const Eigen::VectorXd& y, Eigen::VectorXd& f) {
  if (!evaluate(y, 0, points_)) return false;
  removed_residual(points_, y[y.size() - 1], f);
  return true;
}

/// Precondition: points_ is the figure at y, as residual(y) left it.
bool PaperPlanHomotopy::jacobian(const Eigen::VectorXd& y, const Eigen::VectorXd& f,
                                 Eigen::MatrixXd& jacobian) {
  ++work_.jacobians;
  Eigen::VectorXd shifted = y;
  shifted_residual_.resize(f.size());
  std::size_t first = plan_.instructions().size();
  for (Eigen::Index j = y.size() - 1; j-- > 0;) {
    while (options_.partial ? plan_.driven_before(first) > j : first > 0) --first;
    // A boundary of the domain may lie on one side.
    for (const double direction : {1.0, -1.0}) {
      shifted[j] = y[j] + direction * difference_step(y[j]);
      shifted_points_ = points_;
      if (evaluate(shifted, first, shifted_points_)) break;
      if (direction < 0) return false;
    }
    removed_residual(shifted_points_, y[y.size() - 1], shifted_residual_);
    jacobian.col(j) = (shifted_residual_ - f) / (shifted[j] - y[j]);
    shifted[j] = y[j];
  }
  const Eigen::Index t = y.size() - 1;
  for (const double direction : {1.0, -1.0}) {
    shifted[t] = y[t] + direction * difference_step(y[t]);
    if (evaluate(shifted, 0, shifted_points_)) break;
    if (direction < 0) return false;
  }
  removed_residual(shifted_points_, shifted[t], shifted_residual_);
  jacobian.col(t) = (shifted_residual_ - f) / (shifted[t] - y[t]);
  return true;
}

Eigen::VectorXd PaperPlanHomotopy::figure_coordinates(const Eigen::VectorXd& y) {
  shifted_points_ = points_;
  evaluate(y, 0, shifted_points_);
  Eigen::VectorXd coordinates(dimension_ * shifted_points_.cols() + 1);
  coordinates << Eigen::MatrixXd(shifted_points_.topRows(dimension_)).reshaped(), y[y.size() - 1];
  return coordinates;
}

Figure PaperPlanHomotopy::figure(const Eigen::VectorXd& coordinates) const {
  Figure figure;
  figure.points = sketch_;
  figure.points.topRows(dimension_) =
      coordinates.head(coordinates.size() - 1).reshaped(dimension_, sketch_.cols());
  figure.points /= unit_;
  return figure;
}

bool PaperPlanHomotopy::after_step(const Eigen::VectorXd& before, Eigen::VectorXd& y,
                                   Eigen::VectorXd& tangent) {
  driving_sum_ += plan_.driving_parameters();
  work_.mean_driving_parameters = driving_sum_ / static_cast<double>(work_.iterations);
  work_.max_driving_parameters =
      std::max(work_.max_driving_parameters.value_or(0), plan_.driving_parameters());
  if (!options_.swap) return false;
  evaluate(y, 0, points_);
  if (!needs_change(plan_, options_.rule, points_)) return false;
  double t_before = 0;
  if (!place_before(before, y, tangent, t_before)) return false;
  if (!change(y[y.size() - 1])) return false;
  find_branch(points_);
  y = parameters(points_, y[y.size() - 1]);
  tangent = (y - parameters(shifted_points_, t_before)).normalized();
  return true;
}

/// In shifted_points_.
bool PaperPlanHomotopy::place_before(const Eigen::VectorXd& before, const Eigen::VectorXd& y,
                                     const Eigen::VectorXd& tangent, double& t) {
  shifted_points_ = points_;
  const Eigen::VectorXd from =
      options_.turns_as_printed ? Eigen::VectorXd(y - difference_step(0) * tangent) : before;
  t = from[from.size() - 1];
  if (evaluate(from, 0, shifted_points_)) return true;
  undefined_ = "ϕ is not defined next to the point at which the plan is to be changed";
  return false;
}

std::string PaperPlanHomotopy::configuration(const Eigen::VectorXd& y) {
  if (plan_.instructions().empty() || !evaluate(y, 0, points_)) return "";
  const auto nearest = [&](bool by_sine) {
    const Instruction* found = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Instruction& instruction : plan_.instructions())
      for (int slot = 1; slot < instruction.count; ++slot) {
        const double measure = by_sine ? crossing_sine(instruction, slot, points_)
                                       : boundary_measure(instruction, slot, points_);
        if (measure >= least) continue;
        least = measure;
        found = &instruction;
      }
    return std::pair{found, least};
  };
  const auto [by_gamma, gamma] = nearest(false);
  const auto [by_sine, sine] = nearest(true);
  if (by_gamma == nullptr) return "";
  return fmt::format(
      "; the least γ is {:.2g}, of {}; the spheres of {} meet at the smallest angle, of sine {:.2g}", gamma,
      scene_.problem().name(by_gamma->place), scene_.problem().name(by_sine->place), sine);
}

bool PaperPlanHomotopy::try_other_branch(const Eigen::VectorXd& y) {
  if (options_.swap || !evaluate(y, 0, points_)) return false;
  double nearest = options_.rule.alpha;
  bool found = false;
  for (std::size_t k = 0; k < plan_.instructions().size(); ++k) {
    const double distance = boundary_distance(plan_.instructions()[k], options_.rule, points_);
    if (distance > nearest) continue;
    nearest = distance;
    flipped_ = k;
    found = true;
  }
  if (found) plan_.instructions()[flipped_].side *= -1;
  return found;
}

void PaperPlanHomotopy::take_back_branch() { plan_.instructions()[flipped_].side *= -1; }

}  // namespace gcs
