/// Newton's method, damped, from many random starts: the baseline that every other strategy has to beat.
///
/// A start places every point at random in a box, minimises Σ f_i² over the free coordinates, with
/// f_i = (|p_j − p_k|² − a_i²)/2, by the Levenberg-Marquardt method (Moré, The Levenberg-Marquardt algorithm:
/// implementation and theory, 1978: MINPACK's lmder, which Eigen has in C++), and ends with undamped steps
/// whose residuals are taken in double-double. An end that satisfies all distances to rounding is a solution,
/// unless the Jacobian there is singular or nearly so; any other is a local minimum.
///
/// Nothing tells how many solutions there are. But if n ends at solutions are of w classes, and nothing was
/// known of the sizes of their basins beforehand, w (w + 1) / (n − w − 2) more classes are to be expected
/// (Boender, Rinnooy Kan, Bayesian stopping rules for multistart global optimization methods, 1987), and no
/// more starts are made when that is below `unseen`. It is an estimate and proves nothing: a solution in
/// whose basin hardly a start lies is missed, however small it is.
///
/// Of a general scene (elements/scene_system.hpp) points start in the box too, directions and rotations are random, and the
/// last steps are taken in doubles. What an orientation leaves out has basins like the rest, and is counted among the
/// classes.
///
/// Hence it claims some real solutions. It fails, and says so, where no start ends at a solution, which does
/// not prove that there is none, and at multiple solutions and scenes that move, whose ends it counts only.

#include "solvers/strategies/newton_multistart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <unsupported/Eigen/NonLinearOptimization>

#include "solvers/certificates/nearly_singular.hpp"
#include "solvers/elements/random_figure.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/homotopies/general_start.hpp"
#include "solvers/model/distance_system.hpp"
#include "solvers/numeric/digest.hpp"
#include "solvers/running/run_on_threads.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

/// Starts between two looks at `unseen`: no fewer are made, and their number does not depend on the threads.
constexpr int batch = 64;

/// Half of the starts' box, in longest lengths: points of a rigid figure are seldom further apart than a few.
constexpr double spread = 2;

/// Of the damped steps, relative: from there the undamped ones after them converge quadratically.
constexpr double tolerance = 1e-8;

/// One over the square root of the unit roundoff: at this condition number a fold is so near that the
/// rounding of the lengths can make the solution meet another one and vanish.
constexpr double singular_condition = 9.5e7;

/// In roundings: Newton's method settles at a regular solution to a few times condition · unit roundoff.
constexpr double settled_correction = 64;
constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;

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
  /// Its refinement has residuals in double-double.
  std::optional<Candidate> proven(const Eigen::VectorXd&) const { return std::nullopt; }

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
  /// The real solution next to x, by the file's own numbers: rounded residuals leave stiff ones too uncertain for their
  /// classes.
  std::optional<Candidate> proven(const Eigen::VectorXd& x) const {
    const std::vector<Candidate> found = simple_solutions_near(system_, ComplexValues(x.begin(), x.end()), 1);
    return found.empty() || !found.front().figure.is_real() ? std::nullopt : std::optional(found.front());
  }
  Refinement refined(Eigen::VectorXd& x) const { return refine(equations_, tolerance, x); }

 private:
  const Scene& scene_;
  const SceneSystem system_;
  const RealEquations equations_;
};

/// What became of one start. The figure is a representative of its class.
struct End {
  bool is_solution = false;
  bool is_singular = false;
  Figure figure;
  SolutionAccuracy accuracy;
  WorkCounters work;
};

class NewtonMultistartStrategy final : public Strategy {
 public:
  explicit NewtonMultistartStrategy(const NewtonMultistart& asked)
      : most_starts_(asked.starts), unseen_(asked.unseen) {}

  std::optional<std::string> why_unsupported(const SolveRequest& request) const override {
    const Scene& scene = request.scene;
    if (scene.problem().is_general()) return why_not_general(scene);
    if (scene.is_anchored()) return "it places points and a line in a frame, and the file fixes positions";
    if (scene.problem().lines.size() > 1) return "it places at most one line, and the instance has more";
    return std::nullopt;
  }

  SolveReport solve(const SolveRequest& request) override {
    Tally tally;
    int started = 0;
    do {
      if (request.monitor != nullptr)
        request.monitor->progress("random starts", static_cast<double>(started) / most_starts_);
      const int next = std::min(started + batch, most_starts_);
      for (End& end : ends_of(request, started, next)) tally.take(std::move(end));
      tally.classes = solution_classes(request.scene, tally.figures, tally.accuracies);
      started = next;
    } while (started < most_starts_ && !request.stop.stop_requested() && tally.expects(unseen_));
    return report(request, started, tally);
  }

 private:
  /// The ends at solutions so far, and their classes.
  struct Tally {
    std::vector<Figure> figures;
    std::vector<SolutionAccuracy> accuracies;
    ReflectionClasses classes;
    int singular = 0;  ///< ends
    WorkCounters work;

    void take(End end) {
      add(end.work, work);
      singular += end.is_singular ? 1 : 0;
      if (!end.is_solution) return;
      figures.push_back(std::move(end.figure));
      accuracies.push_back(end.accuracy);
    }

    /// How many classes are unseen, by Boender and Rinnooy Kan; nothing where the ends are too few to tell.
    std::optional<double> unseen() const {
      const double n = static_cast<double>(figures.size()), w = classes.count();
      return n > w + 2 ? std::optional(w * (w + 1) / (n - w - 2)) : std::nullopt;
    }
    bool expects(double more) const { return !unseen() || *unseen() >= more; }
  };

  /// The ends of the starts from `first` to before `last`, in their order, whatever the number of threads.
  std::vector<End> ends_of(const SolveRequest& request, int first, int last) const {
    if (request.scene.problem().is_general()) return ends_of<SceneFunction>(request, first, last);
    return ends_of<DistanceEquations>(request, first, last);
  }

  template <class Equations>
  std::vector<End> ends_of(const SolveRequest& request, int first, int last) const {
    std::vector<End> ends(static_cast<std::size_t>(last - first));
    run_on_threads(request.threads, [&](int thread) {
      Equations equations(request.scene);
      for (int i = first + thread; i < last && !request.stop.stop_requested(); i += request.threads)
        ends[static_cast<std::size_t>(i - first)] = end_of(request, equations, i);
    });
    return ends;
  }

  /// The seed and its number alone say where a start lies.
  static std::mt19937_64 random_numbers(const SolveRequest& request, int number) {
    Digest seed;
    seed.add(request.seed);
    seed.add(static_cast<std::uint64_t>(number));
    return std::mt19937_64(seed.value());
  }

  template <class Equations>
  End end_of(const SolveRequest& request, Equations& equations, int number) const {
    std::mt19937_64 random = random_numbers(request, number);
    Eigen::VectorXd x = equations.random_start(spread * request.scene.size(), random);
    Eigen::LevenbergMarquardt<Equations> method(equations);
    method.parameters.xtol = method.parameters.ftol = tolerance;
    method.minimizeInit(x);
    while (method.minimizeOneStep(x) == Eigen::LevenbergMarquardtSpace::Running &&
           !request.stop.stop_requested()) {
    }
    const Refinement refinement = equations.refined(x);

    End end;
    end.work.iterations = method.njev;
    end.work.newton_iterations = refinement.iterations;
    end.work.evaluations = method.nfev + refinement.iterations;
    end.work.jacobians = end.work.factorisations = method.njev + refinement.iterations;
    end.figure = equations.figure(x);
    if (!refinement.converged || relative_residual(request.scene, end.figure) > double_root_residual)
      return end;
    end.accuracy.condition = jacobian_condition(request.scene, end.figure);
    const double rounding = end.accuracy.condition * unit_roundoff * x.cwiseAbs().maxCoeff();
    end.is_solution = end.accuracy.condition <= singular_condition &&
                      refinement.last_correction <= settled_correction * rounding;
    end.is_singular = !end.is_solution;
    if (!end.is_solution || end.accuracy.condition < stiff_condition) return end;
    if (const auto proven = equations.proven(x)) {
      end.figure = proven->figure;
      end.accuracy.error = proven->error;
    }
    return end;
  }

  static SolveReport report(const SolveRequest& request, int started, const Tally& tally) {
    SolveReport report;
    report.claim = Claim::some_real;
    for (const int first : tally.classes.first)
      report.candidates.push_back({tally.figures[static_cast<std::size_t>(first)]});
    report.work = tally.work;
    report.particulars = {{"starts", started},
                          {"ends_at_solutions", static_cast<std::int64_t>(tally.figures.size())},
                          {"singular_ends", tally.singular}};
    if (const auto unseen = tally.unseen()) {
      Particular& estimate = report.particulars.emplace_back();
      estimate.name = "estimated_unseen_classes";
      estimate.value = std::llround(*unseen);
    }
    const std::string of_all = " of " + std::to_string(started) + " random starts ";
    if (request.stop.stop_requested()) {
      report.status = SolveStatus::stopped;
      report.reason = "stopped on request";
    } else if (tally.singular > static_cast<int>(tally.figures.size())) {  // fewer are accidents
      report.status = report.candidates.empty() ? SolveStatus::gave_up : SolveStatus::partial;
      report.reason =
          std::to_string(tally.singular) + of_all +
          "end where the Jacobian is singular: at solutions that are multiple or not isolated, or "
          "near none";
    } else if (report.candidates.empty()) {
      report.status = SolveStatus::gave_up;
      report.reason = "none" + of_all + "ends at a solution";
    } else {
      report.status = SolveStatus::complete;
    }
    return report;
  }

  int most_starts_;
  double unseen_;
};

}  // namespace

StrategyEntry newton_multistart_entry() {
  StrategyEntry entry = entry_of<NewtonMultistartStrategy, NewtonMultistart>();
  entry.summary = "Levenberg-Marquardt from random starts: some real solutions, the baseline";
  entry.citation = "Moré 1978; Boender, Rinnooy Kan 1987 for when to stop";
  entry.accuracy_settings = {{{"starts", "64"}}};
  entry.knows_general_scenes = true;
  return entry;
}

}  // namespace gcs
