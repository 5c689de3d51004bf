#include "solvers/tracking/flat_refinement.hpp"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <cmath>
#include <limits>
#include <vector>

#include "solvers/numeric/double_double.hpp"

namespace gcs {
namespace {

/// Of a step, relative to the coordinates: half of what rounding them to doubles is.
constexpr double settled_step = 0x1p-54;

/// Of a correction, relative to the coordinates: what double-double leaves of them, and a margin.
constexpr double settled_correction = 0x1p-96;

class FlatCurve {
 public:
  FlatCurve(const WideEquations& equations, const Eigen::VectorXd& near)
      : equations_(equations), jacobian_(near.size(), near.size()) {
    for (const double value : near) x_.push_back({value, 0});
    differentiate();
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian_, Eigen::ComputeFullU | Eigen::ComputeFullV);
    u_ = svd.matrixU().rightCols<1>();
    v_ = svd.matrixV().rightCols<1>();
  }

  /// Back to the curve; false where corrections do not shrink.
  bool correct() {
    constexpr int most_corrections = 20;
    factorise();
    double last = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_corrections; ++i) {
      const Eigen::VectorXd change = factors_.solve(residual());
      move(change, -1);
      const double length = change.norm();
      if (length <= settled_correction * size()) return true;
      if (!(length <= last / 2)) return false;
      last = length;
    }
    return false;
  }

  /// To where τ vanishes along the tangent: how far along v.
  double step() {
    const Eigen::Index n = jacobian_.rows();
    factorise();  // beside the curve τ changes by more than along it
    const Eigen::VectorXd tangent = factors_.solve(Eigen::VectorXd::Unit(n + 1, n));
    const double length = -tau_ / tangent[n];
    if (std::isfinite(length)) move(tangent, length);
    return std::abs(length);
  }

  double size() const { return x().cwiseAbs().maxCoeff(); }
  Eigen::VectorXd x() const {
    Eigen::VectorXd rounded(jacobian_.rows());
    for (Eigen::Index i = 0; i < rounded.size(); ++i) rounded[i] = x_[static_cast<std::size_t>(i)].value();
    return rounded;
  }

 private:
  void differentiate() { equations_.in_doubles().jacobian(x(), jacobian_); }

  void factorise() {
    const Eigen::Index n = jacobian_.rows();
    differentiate();
    Eigen::MatrixXd bordered = Eigen::MatrixXd::Zero(n + 1, n + 1);
    bordered.topLeftCorner(n, n) = jacobian_;
    bordered.topRightCorner(n, 1) = u_;
    bordered.bottomLeftCorner(1, n) = v_.transpose();
    factors_.compute(bordered);
  }

  void move(const Eigen::VectorXd& change, double factor) {
    for (std::size_t i = 0; i < x_.size(); ++i)
      x_[i] = x_[i] + DoubleDouble{factor * change[static_cast<Eigen::Index>(i)], 0};
    tau_ += factor * change[static_cast<Eigen::Index>(x_.size())];
  }

  /// Of F(x) + τ·u and, at right angles to v, 0.
  Eigen::VectorXd residual() const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(jacobian_.rows() + 1);
    const std::vector<DoubleDouble> excess = equations_.excess(x_);
    for (Eigen::Index e = 0; e < jacobian_.rows(); ++e)
      result[e] = (excess[static_cast<std::size_t>(e)] + two_product(tau_, u_[e])).value();
    return result;
  }

  const WideEquations& equations_;
  Eigen::MatrixXd jacobian_;
  std::vector<DoubleDouble> x_;
  double tau_ = 0;
  Eigen::VectorXd u_, v_;
  Eigen::PartialPivLU<Eigen::MatrixXd> factors_;
};

}  // namespace

std::optional<Eigen::VectorXd> flat_refinement(const WideEquations& equations, const Eigen::VectorXd& near,
                                               double most) {
  constexpr int most_steps = 60;
  FlatCurve curve(equations, near);
  double last = most;
  for (int i = 0; i < most_steps && curve.correct(); ++i) {
    const double length = curve.step();
    if (length <= settled_step * curve.size()) return curve.x();
    if (!(length <= last)) break;
    last = length / 2;
  }
  return std::nullopt;
}

}  // namespace gcs
