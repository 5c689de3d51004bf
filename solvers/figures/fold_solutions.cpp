#include "solvers/figures/fold_solutions.hpp"

#include <Eigen/SVD>
#include <cmath>
#include <limits>

namespace gcs {
namespace {

/// Two solutions closer to the fold than so many roundings of a coordinate are not told from none.
constexpr double indistinct = 64;

/// The distance equations at a point, seen along the direction that they determine least.
struct FoldView {
  Eigen::VectorXd v;       ///< that direction
  Eigen::VectorXd across;  ///< Newton's correction in all other directions
  double value = 0;        ///< w·f
  double slope = 0;        ///< w·f_x v, 0 at the fold
  double bend = 0;         ///< w·f''(v, v)
};

FoldView view(const DistanceSystem& system, const std::vector<DoubleDouble>& squares,
              const Eigen::VectorXd& x) {
  const int n = system.unknowns();
  Eigen::MatrixXd jacobian(n, n), moved(n, n);
  Eigen::VectorXd f(n);
  const auto points = [&](const Eigen::VectorXd& at) { return system.figure(at).points; };
  system.residual(points(x), squares, f);
  system.jacobian(points(x), jacobian);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullU | Eigen::ComputeFullV);
  FoldView result;
  result.v = svd.matrixV().rightCols<1>();
  const Eigen::VectorXd w = svd.matrixU().rightCols<1>();
  const auto others = svd.singularValues().head(n - 1).array();
  const Eigen::VectorXd parts = (svd.matrixU().leftCols(n - 1).transpose() * f).array() / others;
  result.across = svd.matrixV().leftCols(n - 1) * parts;
  result.value = w.dot(f);
  result.slope = svd.singularValues()[n - 1];
  // f is quadratic: the change of its Jacobian along v, times v.
  system.jacobian(points(x + result.v), moved);
  result.bend = w.dot((moved - jacobian) * result.v);
  return result;
}

}  // namespace

std::optional<FoldSolutions> along_their_line(FoldSolutions solutions) {
  if (solutions.x.size() == 1) return std::nullopt;
  if (!solutions.x.empty()) solutions.direction = (solutions.x[1] - solutions.x[0]).normalized();
  return solutions;
}

std::optional<FoldSolutions> solutions_at_fold(const DistanceSystem& system,
                                               const std::vector<DoubleDouble>& squares,
                                               const Eigen::VectorXd& near, WorkCounters& work) {
  constexpr int most_steps = 8;
  Eigen::VectorXd x = near;
  for (int i = 0; i < most_steps; ++i) {
    const double rounding = std::numeric_limits<double>::epsilon() * x.cwiseAbs().maxCoeff();
    const FoldView fold = view(system, squares, x);
    ++work.newton_iterations;
    const Eigen::VectorXd step = fold.across + fold.slope / fold.bend * fold.v;
    if (!step.allFinite()) return std::nullopt;
    if (step.norm() > indistinct / 8 * rounding) {
      x -= step;
      continue;
    }
    const double square = -2 * fold.value / fold.bend, s = std::sqrt(std::abs(square));
    if (!(s > indistinct * rounding)) return std::nullopt;
    FoldSolutions result{fold.v, {}};
    if (square < 0) return result;
    for (const double side : {-s, s}) {
      Eigen::VectorXd solution = x + side * fold.v;
      const Eigen::VectorXd start = solution;
      work.newton_iterations += refine(system, squares, solution).iterations;
      if (!((solution - start).norm() < s / 2)) return std::nullopt;
      result.x.push_back(std::move(solution));
    }
    return result;
  }
  return std::nullopt;
}

}  // namespace gcs
