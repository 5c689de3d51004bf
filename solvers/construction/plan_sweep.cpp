#include "solvers/construction/plan_sweep.hpp"

#include <Eigen/LU>

namespace gcs {
namespace {

/// Inverse of the leading block, zero elsewhere.
Eigen::Matrix3d leading_inverse(const Eigen::Matrix3d& normals, int count) {
  Eigen::Matrix3d inverse = Eigen::Matrix3d::Zero();
  if (count == 1) inverse(0, 0) = 1 / normals(0, 0);
  if (count == 2) inverse.topLeftCorner<2, 2>() = normals.topLeftCorner<2, 2>().inverse();
  if (count == 3) inverse = normals.inverse();
  return inverse;
}

}  // namespace

void PlanSweep::configure(const Plan& plan, int constraints) {
  dimension_ = plan.dimension();
  Eigen::Index next_driven = constraints;
  steps_.clear();
  for (const Instruction& instruction : plan.instructions()) {
    Step step;
    step.point = Eigen::Index{dimension_} * instruction.place;
    for (int i = 0; i < instruction.count; ++i) {
      const PlanSphere& sphere = instruction.spheres[i];
      step.edge[i] = sphere.is_driven() ? next_driven++ : sphere.constraint;
      step.center[i] = sphere.is_driven() ? step.point : Eigen::Index{dimension_} * sphere.center;
    }
    steps_.push_back(step);
  }
}

void PlanSweep::linearise(const Plan& plan, const Eigen::Matrix3Xd& points) {
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const Instruction& instruction = plan.instructions()[k];
    Eigen::Matrix3d normals = Eigen::Matrix3d::Zero();
    for (int i = 0; i < instruction.count; ++i)
      normals.row(i) = points.col(instruction.place) - center_of(instruction.spheres[i], points);
    steps_[k].inverse = leading_inverse(normals, instruction.count);
    for (int i = 0; i < instruction.count; ++i)
      if (instruction.spheres[i].is_driven()) normals.row(i).setZero();
    steps_[k].pull = normals;
  }
}

template <int Dimension>
void PlanSweep::solve_in(const Eigen::VectorXd& right, std::size_t first, double* move) const {
  using Vector = Eigen::Matrix<double, Dimension, 1>;
  for (std::size_t k = first; k < steps_.size(); ++k) {
    const Step& step = steps_[k];
    Vector known;
    for (int i = 0; i < Dimension; ++i)
      known[i] = right[step.edge[i]] + step.pull.row(i).template head<Dimension>().dot(
                                           Eigen::Map<const Vector>(move + step.center[i]));
    Eigen::Map<Vector>(move + step.point) =
        step.inverse.template topLeftCorner<Dimension, Dimension>().lazyProduct(known);
  }
}

void PlanSweep::solve(const Eigen::VectorXd& right, std::size_t first, double* move) const {
  if (dimension_ == 2)
    solve_in<2>(right, first, move);
  else
    solve_in<3>(right, first, move);
}

}  // namespace gcs
