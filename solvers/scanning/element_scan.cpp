#include "solvers/scanning/element_scan.hpp"

#include <algorithm>
#include <cmath>

#include "solvers/elements/body_motion.hpp"
#include "solvers/elements/given_elements.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/scanning/element_places.hpp"
#include "solvers/tracking/real_equations.hpp"

namespace gcs {
namespace {

/// Of the last step of Newton's method, which then is past its quadratic phase.
constexpr double last_step = 1e-8;

class ElementScan {
 public:
  ElementScan(const SolveRequest& request, const ElementPlan& plan, const GridScan& asked)
      : request_(request),
        scene_(request.scene),
        plan_(plan),
        asked_(asked),
        places_(scene_, slack()),
        system_(scene_),
        equations_(real_equations(system_.equations())) {}

  SolveReport run() const {
    return scan_slices(
        request_, asked_, no_solutions(),
        [&](std::int64_t number) {
          GridSlice slice{no_solutions()};
          follow(0, {start()}, {number, slice});
          return slice;
        },
        [&](const RefinedSolutions& refined) { return one_of_each_class(refined.list()); });
  }

 private:
  /// Where a branch's first angle is, and what takes its ends.
  struct Way {
    std::int64_t number;
    GridSlice& slice;
  };

  RefinedSolutions no_solutions() const {
    return {std::vector<int>(static_cast<std::size_t>(equations_.unknowns), -1),
            same_solution * std::max(1.0, scene_.size())};
  }

  /// What is fixed or rests in the frame.
  Figure start() const {
    const ProblemStatement problem =
        scene_.is_anchored() ? with_given_body(scene_.problem()) : scene_.problem();
    Figure figure;
    figure.points = Eigen::Matrix3Xd::Zero(3, scene_.point_count());
    figure.lines.resize(problem.lines.size());
    figure.planes.resize(problem.planes.size());
    if (problem.reference_body >= 0)
      for (const BodyElement& element :
           problem.bodies[static_cast<std::size_t>(problem.reference_body)].elements)
        put(problem, element.entity, position_in_body(problem, element, -scene_.unit_exponent()), figure);
    return figure;
  }

  void follow(std::size_t k, const PlacedElement& before, const Way& way) const {
    if (k == plan_.steps.size()) return refine_coarse(before, way.slice);
    const ElementStep& step = plan_.steps[k];
    const auto first = static_cast<std::size_t>(step.first_angle);
    const auto place = [&](const std::array<double, 2>& angles) {
      for (PlacedElement& placed : places_.of(step, before.figure, angles)) {
        placed.misses = placed.misses || before.misses;
        follow(k + 1, placed, way);
      }
    };
    if (step.angles == 0) return place({});
    over(first, way, [&](double angle) {
      if (step.angles == 1) return place({angle, 0});
      over(first + 1, way, [&](double other) { place({angle, other}); });
    });
  }

  template <class Call>
  void over(std::size_t angle, const Way& way, const Call& call) const {
    const AngleGrid& grid = asked_.angles[angle];
    if (angle == 0) return call(grid.at(way.number));
    for (std::int64_t i = 0; i < grid.count && !request_.stop.stop_requested(); ++i) call(grid.at(i));
  }

  bool is_in_band(const Eigen::VectorXd& x, double band) const {
    Eigen::MatrixXd jacobian(equations_.count(), equations_.unknowns);
    equations_.jacobian(x, jacobian);
    const Eigen::VectorXd f = equations_.sums(x) - equations_.given;
    return (f.array().abs() <= band * jacobian.rowwise().norm().array()).all();
  }

  void refine_coarse(const PlacedElement& placed, GridSlice& slice) const {
    Eigen::VectorXd x = real_parts(system_.coordinates_as_drawn(scene_.in_frame(placed.figure)));
    if (!is_in_band(x, placed.misses ? band_of_misses() : asked_.delta)) return;
    ++slice.coarse;
    const Refinement refinement = refine(equations_, last_step, x);
    slice.newton_iterations += refinement.iterations;
    if (refinement.converged)
      slice.refined.take(x);
    else
      ++slice.diverged;
  }

  /// Between two points of the grid a placed element moves by delta, those that are placed by it by several: a branch that
  /// exists only there is looked for where its surfaces miss each other by no more.
  double slack() const { return 4 * asked_.delta; }
  /// Where spheres of radius r that miss each other by the slack are moved together by as much, their common points
  /// are √(2 r slack) from where they were nearest.
  double band_of_misses() const { return std::sqrt(2 * scene_.size() * slack()); }

  std::vector<Candidate> one_of_each_class(const std::vector<Eigen::VectorXd>& ends) const {
    std::vector<Figure> figures;
    std::vector<SolutionAccuracy> accuracies;
    for (const Eigen::VectorXd& x : ends) {
      const Figure figure = scene_.representative(system_.figure(ComplexValues(x.begin(), x.end()), true));
      if (relative_residual(scene_, figure) > double_root_residual) continue;
      figures.push_back(figure);
      accuracies.push_back({jacobian_condition(scene_, figure)});
    }
    std::vector<Candidate> candidates;
    for (const int first : solution_classes(scene_, figures, accuracies).first)
      candidates.push_back({figures[static_cast<std::size_t>(first)]});
    return candidates;
  }

  const SolveRequest& request_;
  const Scene& scene_;
  const ElementPlan& plan_;
  const GridScan& asked_;
  ElementPlaces places_;
  SceneSystem system_;
  RealEquations equations_;
};

}  // namespace

SolveReport element_scan(const SolveRequest& request, const ElementPlan& plan, const GridScan& asked) {
  return ElementScan(request, plan, asked).run();
}

}  // namespace gcs
