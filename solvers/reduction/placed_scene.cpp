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

/// What is stated, each time between these entities.
std::vector<std::vector<int>> stated_between(const ProblemStatement& problem) {
  std::vector<std::vector<int>> all;
  for (const DistanceConstraint& constraint : problem.constraints)
    all.emplace_back(constraint.between.begin(), constraint.between.end());
  for (const Relation& relation : problem.relations) {
    all.emplace_back();
    for (const Operand& operand : relation.of) {
      all.back().push_back(operand.entity);
      if (operand.is_segment()) all.back().push_back(operand.end);
    }
  }
  return all;
}

/// Elements of a part put in the places that a figure of the part gives them, the others anywhere.
Figure in_whole(const Scene& whole, const Scene& part, const std::vector<int>& entities,
                const Figure& figure) {
  const ProblemStatement &problem = whole.problem(), &own = part.problem();
  const Figure scaled = whole.in_scene_unit(part.in_file_unit(figure));
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

/// Of the unknowns of a step the changes of signs that leave all that is placed before: `before`, one mask for each
/// unknown of that.
SignMasks signs_of(const SignMasks& all, const PlacingStep& step, const std::vector<SignMask>& before) {
  SignMasks signs;
  std::vector<SignMask> reduced = before;
  // Masks that differ by what is placed before change the same signs.
  for (std::size_t i = 0; i < reduced.size(); ++i)
    for (std::size_t j = i + 1; j < reduced.size(); ++j)
      if (reduced[i] != 0 && (reduced[j] & reduced[i] & -reduced[i]) != 0) reduced[j] ^= reduced[i];
  for (const int unknown : step.unknowns) {
    SignMask mask = all[static_cast<std::size_t>(unknown)];
    for (const SignMask row : reduced)
      if ((mask & row & -row) != 0) mask ^= row;
    signs.push_back(mask);
  }
  return signs;
}

/// A solution that more changes of signs leave than those that leave all: it is its own mirror image, or nearly.
bool is_flat(const ComplexVectorX& x, const SignMasks& signs, const std::vector<bool>& is_in_core) {
  constexpr double rounding = 1e-9;
  SignMasks all, changing;
  const double size = 1 + largest(x);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!is_in_core[i]) continue;
    all.push_back(signs[i]);
    if (std::abs(x[i]) > rounding * size) changing.push_back(signs[i]);
  }
  return changing.rank() < all.rank();
}

class PlacedSolve {
 public:
  PlacedSolve(const SolveRequest& request, const ElementOrder& order, const PartSolver& solve)
      : request_(request),
        order_(order),
        solve_(solve),
        system_(order.scene),
        equations_(general_equations(system_)) {}

  SolveReport run(std::size_t most_listed) {
    std::vector<PlacedWay> core = order_.core_is_given ? given_core() : solved_core();
    const bool is_flat_somewhere = std::ranges::any_of(core, [&](const PlacedWay& placed) {
      return is_flat(placed.way.values, equations_.signs, unknowns_of_core());
    });
    place_steps();
    report_.status = common_status(reports_, is_empty_);
    report_.claim = common_claim(reports_);
    if (report_.status == SolveStatus::complete) report_.reason.clear();
    PlacedProduct product(request_.scene, order_, system_, equations_, std::move(core), steps_, request_.stop,
                          report_.work);
    report_.candidates = product.list(report_.claim != Claim::all_complex, most_listed);
    if (!is_flat_somewhere)
      count(product);
    else if (report_.candidates.size() >= most_listed)
      leave_open("a solution of the core is its own mirror image, which is not counted without a list");
    note_missing();
    return std::move(report_);
  }

 private:
  std::vector<PlacedWay> given_core() const {
    Figure figure;
    figure.points = Eigen::Matrix3Xd::Zero(3, order_.scene.point_count());
    figure.lines.resize(order_.scene.problem().lines.size());
    figure.planes.resize(order_.scene.problem().planes.size());
    return {{{system_.coordinates(figure), true}, 0}};
  }

  std::vector<PlacedWay> solved_core() {
    const Scene core = Scene::unchecked(order_.core.problem);
    const SceneAnalysis analysis(core.problem());
    take(*solve_(request_.on(core, &analysis)), "");
    const SolveReport& report = reports_.back();
    std::vector<Figure> figures;
    std::vector<SolutionAccuracy> accuracies;
    for (const Candidate& candidate : report.candidates) {
      figures.push_back(core.representative(candidate.figure));
      accuracies.push_back({jacobian_condition(core, figures.back()), candidate.error});
    }
    std::vector<PlacedWay> ways;
    for (const int first : solution_classes(core, figures, accuracies).first) {
      const auto i = static_cast<std::size_t>(first);
      const Figure whole = in_whole(order_.scene, core, order_.core.entities, figures[i]);
      ways.push_back({{system_.coordinates(whole), figures[i].is_real(), report.candidates[i].multiplicity}});
    }
    if (report.totals && report.totals->complex && *report.totals->complex != Natural(ways.size()))
      leave_open("not all solutions of the core are listed");
    return ways;
  }

  void place_steps() {
    std::vector<SignMask> before;
    for (std::size_t i = 0; i < equations_.signs.size(); ++i)
      if (unknowns_of_core()[i]) before.push_back(equations_.signs[i]);
    for (const PlacingStep& step : order_.steps) {
      steps_.emplace_back();
      steps_.back().given = given_ways(step);
      if (!steps_.back().given)
        steps_.back().solver = std::make_unique<StepSolver>(
            equations_, step, signs_of(equations_.signs, step, before), request_);
      for (const int unknown : step.unknowns)
        before.push_back(equations_.signs[static_cast<std::size_t>(unknown)]);
    }
  }

  /// Those of a step that is a scene of its own.
  std::optional<std::vector<PlacedWay>> given_ways(const PlacingStep& step) {
    std::optional<SubProblem> alone = problem_of_step(order_, step);
    if (!alone) return std::nullopt;
    const Scene part = Scene::unchecked(std::move(alone->problem));
    const SceneAnalysis analysis(part.problem());
    std::optional<SolveReport> report = solve_(request_.on(part, &analysis));
    if (!report) return std::nullopt;
    take(std::move(*report), order_.scene.problem().name(step.entity) + ": ");
    return ways_of(step, part, alone->entities, reports_.back());
  }

  std::vector<PlacedWay> ways_of(const PlacingStep& step, const Scene& part, const std::vector<int>& entities,
                                 const SolveReport& report) const {
    const double unit = std::ldexp(1.0, part.unit_exponent() - order_.scene.unit_exponent());
    std::vector<PlacedWay> ways;
    for (const Candidate& candidate : report.candidates) {
      const ComplexVectorX x = system_.coordinates(in_whole(order_.scene, part, entities, candidate.figure));
      PlacedWay placed{{{}, candidate.figure.is_real(), candidate.multiplicity}, candidate.error * unit};
      for (const int unknown : step.unknowns)
        placed.way.values.push_back(x[static_cast<std::size_t>(unknown)]);
      ways.push_back(std::move(placed));
    }
    return ways;
  }

  std::vector<bool> unknowns_of_core() const {
    std::vector<bool> result(equations_.signs.size(), true);
    for (const PlacingStep& step : order_.steps)
      for (const int unknown : step.unknowns) result[static_cast<std::size_t>(unknown)] = false;
    return result;
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
      if (!report.generic) return std::nullopt;
      product = product * Natural(*report.generic);
    }
    for (const PlacedStep& step : steps_) {
      if (!step.solver) continue;
      if (!step.solver->has_all_somewhere()) return std::nullopt;
      product = product * Natural(step.solver->generic_ways());
    }
    return product;
  }

  void note_missing() {
    for (std::size_t i = 0; i < steps_.size(); ++i)
      if (const std::string missing = steps_[i].solver ? steps_[i].solver->missing() : ""; !missing.empty())
        leave_open("placing " + order_.scene.problem().name(order_.steps[i].entity) + ": " + missing);
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
  bool is_empty_ = false;
};

}  // namespace

std::optional<SubProblem> problem_of_step(const ElementOrder& order, const PlacingStep& step) {
  const ProblemStatement& whole = order.scene.problem();
  if (!order.core_is_given || !step.after.empty() || !whole.bodies.empty()) return std::nullopt;
  std::vector<bool> is_there(order.is_in_core.size(), false);
  for (const std::vector<int>& entities : stated_between(whole))
    if (std::ranges::find(entities, step.entity) != entities.end())
      for (const int entity : entities)
        is_there[static_cast<std::size_t>(entity)] = order.is_in_core[static_cast<std::size_t>(entity)];
  is_there[static_cast<std::size_t>(step.entity)] = true;
  return sub_problem(whole, is_there);
}

SolveReport solve_placed(const SolveRequest& request, const ElementOrder& order, const PartSolver& solve,
                         std::size_t most_listed) {
  return PlacedSolve(request, order, solve).run(most_listed);
}

}  // namespace gcs
