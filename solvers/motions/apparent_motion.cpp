#include "solvers/motions/apparent_motion.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <iomanip>
#include <sstream>

#include "solvers/motions/figure_motion.hpp"

namespace gcs {
namespace {

using FigureOf = std::function<Figure(const Eigen::VectorXd&)>;

/// All equations but the one that depends most on the others, where just one dependence is told at x.
std::optional<RealEquations> without_dependent(const RealEquations& equations, const Eigen::VectorXd& x) {
  constexpr double dependent = 1e-9, independent = 1e-6;
  Eigen::MatrixXd jacobian(equations.count(), equations.unknowns);
  equations.jacobian(x, jacobian);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(jacobian, Eigen::ComputeFullU);
  const Eigen::VectorXd sizes = svd.singularValues() / svd.singularValues()[0];
  const Eigen::Index last = sizes.size() - 1;
  if (sizes[last] > dependent || (last > 0 && sizes[last - 1] < independent)) return std::nullopt;
  Eigen::Index left_out = 0;
  svd.matrixU().col(last).cwiseAbs().maxCoeff(&left_out);
  return without(left_out, equations);
}

/// Where an equation stays met along the curve of the others: next to each of its points there is a figure that meets all.
std::optional<Motion> motion_at(const Scene& scene, const RealEquations& equations, const Eigen::VectorXd& x,
                                const FigureOf& figure_of) {
  constexpr int first_steps = 4;
  constexpr double rounding = 1e-12;  // of a few thousand units in the last place
  const std::optional<RealEquations> others = without_dependent(equations, x);
  if (!others || !(motion_from(scene, *others, equations, x, figure_of, first_steps).residual <= rounding))
    return std::nullopt;
  FigureCurve curve = motion_from(scene, *others, equations, x, figure_of, most_motion_steps);
  if (!(curve.residual <= rounding) || curve.figures.size() < 8 * first_steps) return std::nullopt;
  return Motion{{}, {}, 1, false, false, figure_of(x), std::move(curve)};
}

}  // namespace

std::optional<Motion> apparent_motion(const Scene& scene, const RealEquations& equations,
                                      Eigen::VectorXd start, const FigureOf& figure_of,
                                      std::mt19937_64& random) {
  constexpr int tries = 20;
  std::normal_distribution<double> normal(0, scene.size());
  for (int i = 0; i < tries; ++i) {
    const std::optional<Eigen::VectorXd> zero = real_zero_near(equations, start);
    if (zero)
      if (auto motion = motion_at(scene, equations, *zero, figure_of)) return motion;
    for (double& entry : start) entry = normal(random);
  }
  return std::nullopt;
}

std::string apparent_in_words(const std::vector<Motion>& motions) {
  const auto apparent = std::ranges::find(motions, false, &Motion::is_proven);
  if (apparent == motions.end()) return "";
  const FigureCurve& curve = apparent->curve;
  std::ostringstream text;
  text << seems_to_move_words << ": along a " << (curve.end == PathRecord::End::closed ? "closed " : "")
       << "curve of " << curve.figures.size() << " real figures no constraint is off by more than "
       << std::setprecision(1) << curve.residual << " of itself, which proves nothing";
  return text.str();
}

}  // namespace gcs
