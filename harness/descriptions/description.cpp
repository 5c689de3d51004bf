#include "harness/descriptions/description.hpp"

#include "harness/solving/frame_view.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/construction/derive.hpp"
#include "solvers/construction/element_plan.hpp"
#include "solvers/counting/scene_analysis.hpp"
#include "solvers/elements/scene_system.hpp"
#include "solvers/homotopies/general_start.hpp"
#include "solvers/model/reframed_scene.hpp"
#include "solvers/tracking/general_path.hpp"

namespace gcs {
namespace {

std::vector<int> entities_of(const Reference& reference, const ProblemStatement& problem) {
  std::vector<int> entities;
  for (const int point : {reference.origin, reference.axis, reference.plane, reference.height})
    if (point >= 0) entities.push_back(point);
  if (reference.line >= 0) entities.push_back(static_cast<int>(problem.points.size()) + reference.line);
  return entities;
}

ConstructionPlan plan_of_points(const Scene& scene) {
  const ProblemStatement& problem = scene.problem();
  ConstructionPlan description;
  if (const auto reason = why_no_path(scene)) {
    description.why_none = *reason;
    return description;
  }
  description.given = !problem.construction.empty();
  const Plan plan = first_plan(scene, ExchangeRule{});
  description.instructions = describe_plan(scene, plan);
  for (const int constraint : plan.removed())
    description.removed.push_back(problem.constraints[static_cast<std::size_t>(constraint)].id);
  description.driving_parameters = description.removed.size();
  return description;
}

ConstructionPlan plan_of_elements(const Scene& scene) {
  ConstructionPlan description;
  if (const auto reason = why_no_element_plan(scene, Instructions::one_place)) {
    description.why_none = *reason;
    return description;
  }
  const ElementPlan plan = derive_element_plan(scene, Instructions::one_place);
  description.instructions = describe_plan(scene.problem(), plan);
  description.driving_parameters = plan.ranges.size();
  return description;
}

std::vector<StrategyVerdict> verdicts(const SolveRequest& request) {
  std::vector<StrategyVerdict> all;
  for (const StrategyEntry& entry : all_strategies()) {
    const auto strategy = entry.make(complete_options(entry, {}));
    all.push_back({std::string(entry.name), why_not(entry, *strategy, request)});
  }
  return all;
}

DistanceFacts distance_facts(const Scene& scene, const SceneAnalysis& analysis) {
  const ProblemStatement& problem = scene.problem();
  DistanceFacts facts;
  facts.structure = analyse_structure(problem);
  facts.reduction = reduce_to_core(problem, entities_of(scene.reference(), problem));
  facts.parts = analysis.parts(Split::all);
  if (!why_no_path(scene)) facts.positive_support = positive_support(scene.length_paths());
  return facts;
}

GeneralFacts general_facts(const Scene& scene) {
  GeneralFacts facts;
  facts.why_no_system = why_no_system(scene);
  if (facts.why_no_system) return facts;
  const SceneSystem system(scene);
  facts.unknowns = system.equations().unknowns;
  facts.equations = static_cast<int>(system.equations().equations.size());
  facts.why_not_rigid = why_not_general(scene);
  return facts;
}

}  // namespace

Description describe(Instance instance) {
  const Scene scene = instance;
  const SceneAnalysis analysis(instance.problem);
  Description description;
  description.frame = frame_parts(scene);
  description.counts = analysis.counts();
  description.plan =
      is_path_of_elements(scene) ? plan_of_elements(in_frame_of_elements(scene)) : plan_of_points(scene);
  description.strategies = verdicts({scene, {}, &analysis});
  if (instance.problem.is_general())
    description.general = general_facts(scene);
  else
    description.distances = distance_facts(scene, analysis);
  description.instance = std::move(instance);
  return description;
}

std::vector<std::string> names(const ProblemStatement& problem, const std::vector<int>& entities) {
  std::vector<std::string> result;
  for (const int entity : entities) result.push_back(problem.name(entity));
  return result;
}

}  // namespace gcs
