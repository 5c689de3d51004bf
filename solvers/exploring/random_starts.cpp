#include "solvers/exploring/random_starts.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <unsupported/Eigen/NonLinearOptimization>

#include "solvers/certificates/krawczyk_test.hpp"
#include "solvers/elements/random_figure.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/exploring/explored_scene.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/numeric/digest.hpp"
#include "solvers/numeric/rounding.hpp"
#include "solvers/running/run_on_threads.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

/// Half of the starts' box, in longest lengths: points of a rigid figure are seldom further apart than a few.
constexpr double spread = 2;

/// Of the damped steps, relative: from there the undamped ones after them converge quadratically.
constexpr double tolerance = 1e-8;

/// In roundings: Newton's method settles at a regular solution to a few times condition · unit roundoff.
constexpr double settled_correction = 64;

/// The equations between points and a line as Eigen's Levenberg-Marquardt method asks for them.
class DistanceEquations {
 public:
  explicit DistanceEquations(const Scene& scene)
      : scene_(scene),
        system_(scene),
        squares_(target_squares(scene)),
        figure_(system_.figure(Eigen::VectorXd::Zero(inputs()))) {}

  int inputs() const { return system_.unknowns(); }
  int values() const { return system_.equations(); }
  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& f) {
    system_.place(x, figure_.points);
    system_.residual(figure_.points, squares_, f);
    return 0;
  }
  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) {
    system_.place(x, figure_.points);
    system_.jacobian(figure_.points, jacobian);
    return 0;
  }

  Eigen::VectorXd random_start(double reach, std::mt19937_64& random) const {
    std::uniform_real_distribution<double> coordinate(-1, 1);
    return Eigen::VectorXd::NullaryExpr(inputs(), [&] { return reach * coordinate(random); });
  }
  Refinement refined(Eigen::VectorXd& x) const { return refine(system_, squares_, x); }
  Figure figure(const Eigen::VectorXd& x) const { return scene_.representative(system_.figure(x)); }

 private:
  const Scene& scene_;
  const DistanceSystem system_;
  const std::vector<DoubleDouble> squares_;
  Figure figure_;
};

/// Those of a general scene. Bodies start somewhere as they are, and what else equations need follows from where the
/// elements start.
class SceneFunction {
 public:
  explicit SceneFunction(const Scene& scene)
      : scene_(scene), system_(scene), equations_(real_equations(system_.equations())) {}
  SceneFunction(const SceneFunction&) = delete;  // the test refers to the equations

  int inputs() const { return equations_.unknowns; }
  int values() const { return static_cast<int>(equations_.count()); }
  int operator()(const Eigen::VectorXd& x, Eigen::VectorXd& f) const {
    f = equations_.sums(x) - equations_.given;
    return 0;
  }
  int df(const Eigen::VectorXd& x, Eigen::MatrixXd& jacobian) const {
    equations_.jacobian(x, jacobian);
    return 0;
  }

  Eigen::VectorXd random_start(double reach, std::mt19937_64& random) const {
    const ComplexValues values = system_.coordinates_as_drawn(random_figure(scene_, reach, random));
    return Eigen::VectorXd::NullaryExpr(
        inputs(), [&](Eigen::Index i) { return values[static_cast<std::size_t>(i)].real(); });
  }
  Figure figure(const Eigen::VectorXd& x) const {
    return system_.figure(ComplexValues(x.begin(), x.end()), true);
  }
  /// In doubles, and then with residuals in double-double.
  Refinement refined(Eigen::VectorXd& x) const {
    Refinement refinement = refine(equations_, tolerance, x);
    Eigen::VectorXd settled = x;
    std::int64_t iterations = 0;
    if (refinement.converged && values() == inputs() && test_.refine(settled, iterations)) x = settled;
    refinement.iterations += static_cast<int>(iterations);
    return refinement;
  }

 private:
  const Scene& scene_;
  const SceneSystem system_;
  const RealEquations equations_;
  const IntervalEquations exact_{system_.equations()};
  const KrawczykTest test_{exact_, scene_.size()};
};

/// The seed and its number alone say where a start lies.
std::mt19937_64 random_numbers(const SolveRequest& request, int number) {
  Digest seed;
  seed.add(request.seed);
  seed.add(static_cast<std::uint64_t>(number));
  return std::mt19937_64(seed.value());
}

template <class Equations>
StartEnd end_of(const SolveRequest& request, Equations& equations, int number) {
  std::mt19937_64 random = random_numbers(request, number);
  Eigen::VectorXd x = equations.random_start(spread * request.scene.size(), random);
  Eigen::LevenbergMarquardt<Equations> method(equations);
  method.parameters.xtol = method.parameters.ftol = tolerance;
  method.minimizeInit(x);
  while (method.minimizeOneStep(x) == Eigen::LevenbergMarquardtSpace::Running &&
         !request.stop.stop_requested()) {
  }
  const Refinement refinement = equations.refined(x);

  StartEnd end;
  end.work.iterations = method.njev;
  end.work.newton_iterations = refinement.iterations;
  end.work.evaluations = method.nfev + refinement.iterations;
  end.work.jacobians = end.work.factorisations = method.njev + refinement.iterations;
  end.figure = equations.figure(x);
  if (!refinement.converged || relative_residual(request.scene, end.figure) > double_root_residual)
    return end;
  end.accuracy.condition = jacobian_condition(request.scene, end.figure);
  const double rounding = end.accuracy.condition * unit_roundoff * x.cwiseAbs().maxCoeff();
  end.is_solution = end.accuracy.condition <= singular_solution_condition &&
                    refinement.last_correction <= settled_correction * rounding;
  end.is_singular = !end.is_solution;
  return end;
}

template <class Equations>
std::vector<StartEnd> ends_with(const SolveRequest& request, int first, int last) {
  std::vector<StartEnd> ends(static_cast<std::size_t>(last - first));
  run_on_threads(request.threads, [&](int thread) {
    Equations equations(request.scene);
    for (int i = first + thread; i < last && !request.stop.stop_requested(); i += request.threads)
      ends[static_cast<std::size_t>(i - first)] = end_of(request, equations, i);
  });
  return ends;
}

/// A solution if one is proven next to it; others that are there too come after all ends.
void settle(const Scene& scene, const std::vector<Candidate>& proven, StartEnd& end,
            std::vector<StartEnd>& more) {
  end.is_solution = !proven.empty();
  end.is_singular = proven.empty();
  for (std::size_t i = 0; i < proven.size(); ++i) {
    StartEnd& one = i == 0 ? end : more.emplace_back();
    one.is_solution = true;
    one.accuracy = {end.accuracy.condition, proven[i].error};
    one.figure = scene.representative(proven[i].figure);
  }
}

/// Singular ends and stiff ones: a figure may meet all equations to rounding and be next to no solution.
void settle_ends(const SolveRequest& request, ProvenNeighbours& neighbours, std::vector<StartEnd>& ends) {
  std::vector<StartEnd> more;
  for (StartEnd& end : ends) {
    if (request.stop.stop_requested()) break;
    const bool is_stiff = end.is_solution && end.accuracy.condition >= stiff_condition;
    if (is_stiff) end.accuracy.error = neighbours.error_of(end.figure);
    if ((end.is_singular && !neighbours.is_hopeless()) || (is_stiff && !std::isfinite(end.accuracy.error)))
      settle(request.scene, neighbours.of(end.figure), end, more);
  }
  std::ranges::move(more, std::back_inserter(ends));
}

}  // namespace

std::vector<StartEnd> ends_of_starts(const SolveRequest& request, int first, int last,
                                     ProvenNeighbours& neighbours) {
  std::vector<StartEnd> ends = is_explored_by_elements(request.scene)
                                   ? ends_with<SceneFunction>(request, first, last)
                                   : ends_with<DistanceEquations>(request, first, last);
  settle_ends(request, neighbours, ends);
  return ends;
}

}  // namespace gcs
