#include "solvers/motions/figure_motion.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <limits>
#include <utility>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/numeric/dense_factors.hpp"
#include "solvers/tracking/released_curve.hpp"
#include "solvers/tracking/whole_curve.hpp"

namespace gcs {
namespace {

Eigen::MatrixXd real_jacobian(const RealEquations& equations, const Eigen::VectorXd& x) {
  Eigen::MatrixXd matrix(equations.count(), equations.unknowns);
  equations.jacobian(x, matrix);
  return matrix;
}

/// Of length 1, its largest entry positive.
Eigen::VectorXd tangent_at(const RealEquations& equations, const Eigen::VectorXd& x) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(real_jacobian(equations, x), Eigen::ComputeFullV);
  const Eigen::VectorXd tangent = svd.matrixV().rightCols<1>();
  Eigen::Index largest = 0;
  tangent.cwiseAbs().maxCoeff(&largest);
  return tangent[largest] < 0 ? Eigen::VectorXd(-tangent) : tangent;
}

/// One equation more: how far x is along the tangent, which the curve is then followed by.
RealEquations with_place_along(const Eigen::VectorXd& tangent, const Eigen::VectorXd& x,
                               RealEquations equations) {
  RealForm place;
  for (Eigen::Index i = 0; i < tangent.size(); ++i) place.terms.emplace_back(static_cast<int>(i), tangent[i]);
  equations.products.push_back({equations.count(), place, RealForm{{}, 1}});
  equations.given.conservativeResize(equations.count() + 1);
  equations.given[equations.count() - 1] = tangent.dot(x);
  return equations;
}

/// Within a hundred times the tolerance of the tracker.
std::optional<Eigen::VectorXd> zero_beside(const RealEquations& equations, const Eigen::VectorXd& x) {
  constexpr double nearby = 1e-5;
  const std::optional<Eigen::VectorXd> zero = real_zero_near(equations, x);
  if (zero && (*zero - x).norm() <= nearby * (1 + x.norm())) return zero;
  return std::nullopt;
}

PathRecord::End end_of(const TrackedPath& path, bool is_long) {
  if (path.end == TrackedPath::End::closed) return PathRecord::End::closed;
  if (is_long) return PathRecord::End::stopped;
  return path.end == TrackedPath::End::at_infinity ? PathRecord::End::at_infinity : PathRecord::End::singular;
}

}  // namespace

std::optional<Eigen::VectorXd> real_zero_near(const RealEquations& equations, Eigen::VectorXd x) {
  constexpr int most_iterations = 60;
  constexpr double settled = 1e-14, hardly_told = 1e-6;
  for (int i = 0; i < most_iterations && x.allFinite(); ++i) {
    const Eigen::VectorXd off = equations.sums(x) - equations.given;
    const double size = equations.given.lpNorm<Eigen::Infinity>() + x.squaredNorm();
    if (off.lpNorm<Eigen::Infinity>() <= settled * size) return x;
    x -= shortest_solution(real_jacobian(equations, x), off, hardly_told);
  }
  return std::nullopt;
}

FigureCurve motion_from(const Scene& scene, const RealEquations& equations, const RealEquations& met,
                        const Eigen::VectorXd& x,
                        const std::function<Figure(const Eigen::VectorXd&)>& figure_of, int most_steps) {
  SeriesTrackerOptions options;
  options.max_steps = most_steps;
  options.step_max_far = 0.1;
  options.kept_points = 8;
  const RealEquations placed = with_place_along(tangent_at(equations, x), x, equations);
  const SignMasks none(std::vector<SignMask>(static_cast<std::size_t>(equations.unknowns), 0));
  bool is_long = false;
  const TrackedPath path = whole_curve(
      [&](const SeriesTrackerOptions& of_half) {
        ReleasedCurve curve(ReleasedFamily::at_solution(placed, none, equations.count(), x, of_half.order),
                            of_half.tolerance);
        TrackedPath half = SeriesTracker(curve, of_half, {}).run();
        is_long |= half.work.iterations >= most_steps;
        return half;
      },
      options);
  FigureCurve result{{}, end_of(path, is_long), 0};
  for (const Eigen::VectorXd& point : path.points) {
    const std::optional<Eigen::VectorXd> zero = zero_beside(met, point.head(equations.unknowns));
    if (zero) result.figures.push_back(figure_of(*zero));
    result.residual = std::max(result.residual, zero ? relative_residual(scene, result.figures.back())
                                                     : std::numeric_limits<double>::infinity());
  }
  return result;
}

}  // namespace gcs
