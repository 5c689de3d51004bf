#include "solvers/reduction/placed_scene.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "solvers/counting/scene_analysis.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/figures/solution_classes.hpp"
#include "solvers/reduction/part_reports.hpp"
#include "solvers/reduction/placed_product.hpp"

namespace gcs {
namespace {

/// Elements of a part put in the places that a figure of the part gives them, the others anywhere.
Figure in_whole(const Scene& whole, const Scene& part, const std::vector<int>& entities,
                const Figure& figure) {
  const ProblemStatement &problem = whole.problem(), &own = part.problem();
  const Figure scaled = figure.scaled(part.unit_exponent() - whole.unit_exponent());
  const bool is_real = scaled.is_real();
  Figure result;
  result.points = Eigen::Matrix3Xd::Zero(3, whole.point_count());
  result.lines.resize(problem.lines.size());
  result.planes.resize(problem.planes.size());
  if (!is_real) {
    result.imaginary = result.points;
    result.imaginary_lines.assign(problem.lines.size(), {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
    result.imaginary_planes.assign(problem.planes.size(), {Eigen::Vector3d::Zero(), 0});
  }
  const auto place = [](auto& all, const auto& of_part, int to, int from) {
    all[static_cast<std::size_t>(to)] = of_part[static_cast<std::size_t>(from)];
  };
  for (int i = 0; i < own.entity_count(); ++i) {
    const int entity = entities[static_cast<std::size_t>(i)];
    if (own.is_point(i)) {
      result.points.col(entity) = scaled.points.col(i);
      if (!is_real) result.imaginary.col(entity) = scaled.imaginary.col(i);
    } else if (own.is_line(i)) {
      place(result.lines, scaled.lines, problem.line_of(entity), own.line_of(i));
      if (!is_real)
        place(result.imaginary_lines, scaled.imaginary_lines, problem.line_of(entity), own.line_of(i));
    } else {
      place(result.planes, scaled.planes, problem.plane_of(entity), own.plane_of(i));
      if (!is_real)
        place(result.imaginary_planes, scaled.imaginary_planes, problem.plane_of(entity), own.plane_of(i));
    }
  }
  return result;
}

void append(const std::string& sentence, std::string& reason) {
  reason += (reason.empty() ? "" : "; ") + sentence;
}

/// The mirror image of a figure in the frame of a core.
Figure mirrored(Figure figure, int dimension) {
  const int axis = dimension - 1;
  figure.points.row(axis) *= -1;
  if (figure.imaginary.cols() > 0) figure.imaginary.row(axis) *= -1;
  for (auto* lines : {&figure.lines, &figure.imaginary_lines})
    for (LinePosition& line : *lines) {
      line.point[axis] *= -1;
      line.direction[axis] *= -1;
    }
  for (auto* planes : {&figure.planes, &figure.imaginary_planes})
    for (PlanePosition& plane : *planes) plane.normal[axis] *= -1;
  return figure;
}

constexpr double rounding = 1e-9;  // of the largest unknown

/// A solution that more changes of signs leave than those that leave all: it is its own mirror image, or nearly.
bool is_flat(const ComplexVectorX& values, const SignMasks& signs) {
  SignMasks changing;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (std::abs(values[i]) > rounding * (1 + largest(values))) changing.push_back(signs[i]);
  return changing.rank() < signs.rank();
}

bool are_equal(const ComplexVectorX& a, const ComplexVectorX& b) {
  const double size = 1 + largest(a);
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::abs(a[i] - b[i]) > rounding * size) return false;
  return true;
}

class PlacedSolve {
 public:
  PlacedSolve(const SolveRequest& request, const ElementOrder& order, const PartSolver& solve)
      : request_(request),
        order_(order),
        solve_(solve),
        system_(order.scene),
        equations_(general_equations(system_)) {}

  std::optional<SolveReport> run(std::size_t most_listed) {
    if (!place_steps()) return std::nullopt;
    report_.status = common_status(reports_, is_empty_);
    report_.claim = common_claim(reports_);
    if (report_.status == SolveStatus::complete) report_.reason.clear();
    PlacedProduct product(request_.scene, order_, system_, equations_, steps_, request_.stop, report_.work);
    report_.candidates = product.list(report_.claim != Claim::all_complex, most_listed);
    if (!is_flat_somewhere_)
      count(product);
    else if (report_.candidates.size() >= most_listed)
      leave_open("a solution of a part is its own mirror image, which is not counted without a list");
    note_missing();
    return std::move(report_);
  }

 private:
  /// False where a step has no way at random numbers.
  bool place_steps() {
    for (const PlacingStep& step : order_.steps) {
      steps_.emplace_back();
      if (step.alone) steps_.back().given = ways_alone(step, steps_.back().totals);
      if (!steps_.back().given)
        steps_.back().solver = std::make_unique<StepSolver>(equations_, step, request_);
      const bool has_ways = !steps_.back().solver || steps_.back().solver->generic_ways() > 0;
      if (!has_ways && !request_.stop.stop_requested()) return false;
    }
    return true;
  }

  /// One for each class that is found, or two. `totals`: where they are more than are listed.
  std::optional<std::vector<PlacedWay>> ways_alone(const PlacingStep& step,
                                                   std::optional<SolutionTotals>& totals) {
    const Scene part = Scene::unchecked(step.alone->problem);
    const SceneAnalysis analysis(part.problem());
    SolveRequest of_part = request_.on(part, &analysis);
    of_part.most_listed.reset();
    std::optional<SolveReport> found = solve_(step, of_part);
    if (!found) return std::nullopt;
    take(std::move(*found), step.name.empty() ? "" : step.name + ": ");
    const SolveReport& report = reports_.back();
    std::vector<Figure> figures;
    std::vector<SolutionAccuracy> accuracies;
    for (const Candidate& candidate : report.candidates) {
      figures.push_back(part.representative(candidate.figure));
      accuracies.push_back({jacobian_condition(part, figures.back()), candidate.error});
    }
    const std::vector<int> classes = solution_classes(part, figures, accuracies).first;
    if (report.totals && report.totals->complex && *report.totals->complex != Natural(classes.size()))
      totals = unlisted(step, *report.totals);
    std::vector<PlacedWay> ways;
    for (const int first : classes) {
      const auto i = static_cast<std::size_t>(first);
      ways.push_back(way_of(step, part, figures[i], report.candidates[i]));
      if (!step.has_two_sides) continue;
      PlacedWay other = way_of(step, part, mirrored(figures[i], part.dimension()), report.candidates[i]);
      if (!are_equal(other.way.values, ways.back().way.values)) ways.push_back(std::move(other));
    }
    return ways;
  }

  /// Nothing where another step depends on which one it is.
  std::optional<SolutionTotals> unlisted(const PlacingStep& step, SolutionTotals totals) {
    const auto number = static_cast<int>(&step - order_.steps.data());
    const bool is_needed = std::ranges::any_of(order_.steps, [number](const PlacingStep& later) {
      return std::ranges::find(later.after, number) != later.after.end();
    });
    if (is_needed) leave_open("not all solutions of a part are listed");
    if (is_needed) return std::nullopt;
    for (std::optional<Natural>* total : {&totals.real, &totals.complex})
      if (*total && step.has_two_sides) *total = **total * Natural(2);
    return totals;
  }

  PlacedWay way_of(const PlacingStep& step, const Scene& part, const Figure& figure,
                   const Candidate& candidate) {
    const double unit = std::ldexp(1.0, part.unit_exponent() - order_.scene.unit_exponent());
    const ComplexVectorX x = system_.coordinates(in_whole(order_.scene, part, step.alone->entities, figure));
    PlacedWay placed{{{}, figure.is_real(), candidate.multiplicity}, candidate.error * unit};
    for (const int unknown : step.unknowns) placed.way.values.push_back(x[static_cast<std::size_t>(unknown)]);
    is_flat_somewhere_ = is_flat_somewhere_ || is_flat(placed.way.values, step.signs);
    return placed;
  }

  void take(SolveReport report, const std::string& name) {
    if (!report.reason.empty()) append(name + report.reason, report_.reason);
    report_.paths.insert(report_.paths.end(), report.paths.begin(), report.paths.end());
    add(report.work, report_.work);
    add(report.particulars, report_.particulars);
    is_empty_ = is_empty_ || (report.candidates.empty() && claims_all(report.claim) &&
                              report.status == SolveStatus::complete);
    reports_.push_back(std::move(report));
  }

  void leave_open(const std::string& sentence) { append(sentence, open_); }

  void count(PlacedProduct& product) {
    SolutionTotals& totals = report_.totals.emplace();
    if (claims_all(report_.claim)) totals.real = product.count(true);
    if (report_.claim == Claim::all_complex) totals.complex = product.count(false);
    const bool is_open = (claims_all(report_.claim) && !totals.real) ||
                         (report_.claim == Claim::all_complex && !totals.complex);
    if (is_open && !request_.stop.stop_requested())
      leave_open("there are more choices than can be looked at");
    totals.generic = generic_product();
  }

  /// Steps by paths have the number that was met somewhere.
  std::optional<Natural> generic_product() const {
    Natural product(1);
    for (const SolveReport& report : reports_) {
      std::optional<Natural> generic = report.totals ? report.totals->generic : std::nullopt;
      if (report.generic) generic = Natural(*report.generic);
      if (!generic) return std::nullopt;
      product = product * *generic;
    }
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      if (order_.steps[i].has_two_sides) product = product * Natural(2);
      if (!steps_[i].solver) continue;
      if (!steps_[i].solver->has_all_somewhere()) return std::nullopt;
      product = product * Natural(steps_[i].solver->generic_ways());
    }
    return product;
  }

  void note_missing() {
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (const std::string missing = steps_[i].solver ? steps_[i].solver->missing() : ""; !missing.empty())
        leave_open("placing " + order_.steps[i].name + ": " + missing);
    if (request_.stop.stop_requested()) {
      report_.status = SolveStatus::stopped;
      report_.reason = "stopped on request";
    } else if (!open_.empty()) {
      append(open_, report_.reason);
      if (report_.status == SolveStatus::complete) report_.status = SolveStatus::partial;
    }
  }

  const SolveRequest& request_;
  const ElementOrder& order_;
  const PartSolver& solve_;
  SceneSystem system_;
  GeneralEquations equations_;
  std::vector<SolveReport> reports_;
  std::vector<PlacedStep> steps_;
  SolveReport report_;
  std::string open_;  ///< what may have been left out where no report says so
  bool is_empty_ = false, is_flat_somewhere_ = false;
};

}  // namespace

std::optional<SolveReport> solve_placed(const SolveRequest& request, const ElementOrder& order,
                                        const PartSolver& solve, std::size_t most_listed) {
  return PlacedSolve(request, order, solve).run(most_listed);
}

}  // namespace gcs
