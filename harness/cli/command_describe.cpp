/// gcsbench describe: what is known of an instance before any solving.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "harness/base/atomic_file.hpp"
#include "harness/cli/argument_checks.hpp"
#include "harness/cli/commands.hpp"
#include "harness/drawings/tree_drawing.hpp"
#include "harness/instances/instance_lookup.hpp"
#include "harness/solving/counts_view.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/construction/derive.hpp"
#include "solvers/counting/scene_analysis.hpp"
#include "solvers/reading/json_build.hpp"
#include "solvers/structure/core_reduction.hpp"
#include "solvers/structure/structure.hpp"
#include "solvers/tracking/path_report.hpp"

namespace gcs {

namespace {

struct DescribeArguments {
  std::string instance;
  bool json = false;
  std::string tree;  ///< the file for the interpretation tree; empty: none
};

/// The plan that a path strategy starts with.
struct ConstructionPlan {
  bool given = false;                     ///< by the file; otherwise derived
  std::vector<std::string> instructions;  ///< "p4 = interSSS(p1, a4, p2, a5, p3', k1)"
  std::vector<std::string> removed;       ///< ids of the constraints that driving parameters replace
};

struct StrategyVerdict {
  std::string name;
  std::optional<std::string> why_not;  ///< empty: it applies
};

/// Everything that is shown; text and JSON are two views of it.
struct Description {
  Instance instance;
  Structure structure;
  Reference reference;
  CoreReduction reduction;
  std::vector<Part> parts;  ///< as the option reduce=on takes the scene apart
  TheoreticalCounts counts;
  std::optional<TimeRange>
      positive_support;                  ///< empty where S, and so a figure to start from, is not defined
  std::optional<ConstructionPlan> plan;  ///< likewise
  std::vector<StrategyVerdict> strategies;
};

std::vector<int> entities_of(const Reference& reference, const ProblemStatement& problem) {
  std::vector<int> entities;
  for (const int point : {reference.origin, reference.axis, reference.plane, reference.height})
    if (point >= 0) entities.push_back(point);
  if (reference.line >= 0) entities.push_back(static_cast<int>(problem.points.size()) + reference.line);
  return entities;
}

std::optional<ConstructionPlan> construction_plan(const Scene& scene) {
  if (why_no_path(scene)) return std::nullopt;
  const ProblemStatement& problem = scene.problem();
  ConstructionPlan description;
  description.given = !problem.construction.empty();
  const Plan plan = first_plan(scene, ExchangeRule{});
  description.instructions = describe_plan(scene, plan);
  for (const int constraint : plan.removed())
    description.removed.push_back(problem.constraints[constraint].id);
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

Description describe(Instance instance) {
  const Scene scene = instance;
  const SceneAnalysis analysis(instance.problem);
  Description description;
  description.structure = analyse_structure(instance.problem);
  description.reference = scene.reference();
  description.reduction =
      reduce_to_core(instance.problem, entities_of(description.reference, instance.problem));
  description.parts = analysis.parts(Split::all);
  description.counts = analysis.counts();
  if (!why_no_path(scene)) description.positive_support = positive_support(scene.length_paths());
  description.plan = construction_plan(scene);
  description.strategies = verdicts({scene, {}, &analysis});
  description.instance = std::move(instance);
  return description;
}

std::vector<std::string> names(const ProblemStatement& problem, const std::vector<int>& entities) {
  std::vector<std::string> result;
  for (const int entity : entities) result.push_back(problem.name(entity));
  return result;
}

std::vector<std::string> fixed_names(const ProblemStatement& problem) {
  std::vector<std::string> result;
  for (int entity = 0; entity < static_cast<int>(problem.points.size() + problem.lines.size()); ++entity)
    if (problem.is_fixed(entity)) result.push_back(problem.name(entity));
  return result;
}

/// The parts of the reference that are used, by the names of the instance format;
/// none where positions are fixed.
std::vector<std::pair<std::string, std::string>> reference_parts(const Description& description) {
  const ProblemStatement& problem = description.instance.problem;
  const Reference& reference = description.reference;
  std::vector<std::pair<std::string, std::string>> parts;
  if (!fixed_names(problem).empty()) return parts;
  const auto append = [&](const char* part, int index, const std::vector<std::string>& names_of_kind) {
    if (index >= 0) parts.emplace_back(part, names_of_kind[index]);
  };
  append("origin", reference.origin, problem.points);
  append("axis", reference.axis, problem.points);
  append("plane", reference.plane, problem.points);
  append("line", reference.line, problem.lines);
  append("height", reference.height, problem.points);
  return parts;
}

// ---- JSON

JsonValue freedom_value(const Structure& structure) {
  return json_object({{"unknowns", json_number(structure.unknowns)},
                      {"constraints", json_number(structure.constraints)},
                      {"generic_rank", json_number(structure.generic_rank)},
                      {"rigid", json_boolean(structure.generic_rank == structure.unknowns)}});
}

JsonValue end_value(double t) { return std::isfinite(t) ? json_number(t) : json_null(); }

JsonValue interpolation_value(const Description& description) {
  const ProblemStatement& problem = description.instance.problem;
  if (!problem.sketch) return json_null();
  JsonMembers members;
  const std::vector<BentLength> bends = bent_lengths(problem);
  if (problem.interpolation.bends) {
    JsonMembers all;
    for (const BentLength& bent : bends)
      all.emplace_back(problem.constraints[bent.constraint].id,
                       json_array_of(bent.coefficients, json_number));
    members.emplace_back("bends", json_object(std::move(all)));
  } else {
    members.emplace_back("bent", json_text(problem.constraints[bends.front().constraint].id));
    members.emplace_back("bend", json_number(bends.front().coefficients.front()));
  }
  if (const auto& support = description.positive_support) {
    members.emplace_back("positive_support", json_array({end_value(support->low), end_value(support->high)}));
    members.emplace_back("compact", json_boolean(support->is_bounded()));
  }
  return json_object(std::move(members));
}

JsonValue core_value(const ProblemStatement& problem, const CoreReduction& reduction) {
  std::vector<std::string> constraints;
  for (const int i : reduction.core_constraints) constraints.push_back(problem.constraints[i].id);
  std::vector<JsonValue> placed;
  for (const PlacedPoint& point : reduction.placed)
    placed.push_back(json_object(
        {{"place", json_text(problem.name(point.point))}, {"from", json_texts(names(problem, point.from))}}));
  return json_object({{"trivial", json_boolean(reduction.core_is_trivial)},
                      {"entities", json_texts(names(problem, reduction.core))},
                      {"constraints", json_texts(constraints)},
                      {"placed", json_array(std::move(placed))}});
}

JsonValue parts_value(const ProblemStatement& problem, const std::vector<Part>& parts) {
  std::vector<JsonValue> values;
  for (const Part& part : parts)
    values.push_back(json_object({{"base", json_texts(names(problem, part.base))},
                                  {"places", json_texts(names(problem, part.points))},
                                  {"hung", json_boolean(part.is_hung_point())}}));
  return json_array(std::move(values));
}

JsonValue plan_value(const ConstructionPlan& plan) {
  return json_object({{"given", json_boolean(plan.given)},
                      {"driving_parameters", json_count(plan.removed.size())},
                      {"removed", json_texts(plan.removed)},
                      {"instructions", json_texts(plan.instructions)}});
}

JsonValue strategies_value(const std::vector<StrategyVerdict>& strategies) {
  std::vector<JsonValue> values;
  for (const StrategyVerdict& verdict : strategies)
    values.push_back(json_object({{"name", json_text(verdict.name)},
                                  {"applies", json_boolean(!verdict.why_not)},
                                  {"why_not", json_or_null(verdict.why_not, json_text)}}));
  return json_array(std::move(values));
}

JsonValue reference_value(const Description& description) {
  JsonMembers members;
  for (const auto& [part, name] : reference_parts(description)) members.emplace_back(part, json_text(name));
  return json_object(std::move(members));
}

std::string json_description(const Description& description) {
  const Instance& instance = description.instance;
  const ProblemStatement& problem = instance.problem;
  const JsonValue* published = instance.document.find("published");
  const JsonValue value = json_object({{"id", json_text(instance.id)},
                                       {"title", json_text(instance.title)},
                                       {"dimension", json_number(problem.dimension)},
                                       {"points", json_texts(problem.points)},
                                       {"lines", json_texts(problem.lines)},
                                       {"fixed", json_texts(fixed_names(problem))},
                                       {"degrees_of_freedom", freedom_value(description.structure)},
                                       {"reference", reference_value(description)},
                                       {"sketch", json_boolean(problem.sketch.has_value())},
                                       {"interpolation", interpolation_value(description)},
                                       {"core", core_value(problem, description.reduction)},
                                       {"parts", parts_value(problem, description.parts)},
                                       {"theoretical_counts", counts_value(problem, description.counts)},
                                       {"construction", json_or_null(description.plan, plan_value)},
                                       {"strategies", strategies_value(description.strategies)},
                                       {"published", published ? *published : json_array({})}});
  return to_text(value, 1) + "\n";
}

// ---- text

std::string join(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::string entities_text(const ProblemStatement& problem) {
  std::string text = fmt::format("{} points", problem.points.size());
  if (!problem.lines.empty())
    text += fmt::format(", {} line{}", problem.lines.size(), problem.lines.size() == 1 ? "" : "s");
  return text + (problem.dimension == 2 ? " in the plane" : " in space");
}

std::string freedom_text(const Structure& structure) {
  const bool rigid = structure.generic_rank == structure.unknowns;
  return fmt::format("{} unknown coordinates, {} constraints of generic rank {}: {}", structure.unknowns,
                     structure.constraints, structure.generic_rank, rigid ? "rigid" : "not rigid");
}

std::string reference_text(const Description& description) {
  std::vector<std::string> parts;
  for (const auto& [part, name] : reference_parts(description)) parts.push_back(part + " " + name);
  return parts.empty() ? "none: positions are fixed" : join(parts);
}

std::string sketch_text(const ProblemStatement& problem) {
  if (!problem.sketch) return "none";
  std::vector<std::string> bent;
  for (const BentLength& one : bent_lengths(problem))
    bent.push_back(fmt::format("{} is bent by {}", problem.constraints[one.constraint].id,
                               fmt::join(one.coefficients, " ")));
  return bent.empty() ? "given; all lengths change linearly"
                      : fmt::format("given; {}, the other lengths change linearly", join(bent));
}

/// Whether S closes, as far as the lengths decide it ([I] (h2)).
std::string support_text(const TimeRange& support) {
  if (support.is_bounded())
    return fmt::format("for t from {:.6g} to {:.6g}: S closes where it is regular (hypothesis h2)",
                       support.low, support.high);
  const std::string where = std::isfinite(support.low)    ? fmt::format("for t from {:.6g} on", support.low)
                            : std::isfinite(support.high) ? fmt::format("for t up to {:.6g}", support.high)
                                                          : "for every t";
  return where + ": S may run off to infinity (hypothesis h2 does not hold)";
}

std::string core_text(const ProblemStatement& problem, const CoreReduction& reduction) {
  const std::string list = join(names(problem, reduction.core));
  if (reduction.core_is_trivial) return "none: everything is placed one by one, starting from " + list;
  return fmt::format("{} constraints between {}", reduction.core_constraints.size(), list);
}

std::string placed_text(const ProblemStatement& problem, const CoreReduction& reduction) {
  constexpr std::size_t most = 20;
  std::vector<std::string> placed;
  for (const PlacedPoint& point : reduction.placed)
    if (placed.size() < most)
      placed.push_back(
          fmt::format("{} from {}", problem.name(point.point), fmt::join(names(problem, point.from), " ")));
  if (placed.empty()) return "nothing";
  const std::size_t more = reduction.placed.size() - placed.size();
  return join(placed) + (more > 0 ? fmt::format(" and {} more", more) : "");
}

/// A row for the parts that are solved one by one, where there are several.
std::string parts_text(const ProblemStatement& problem, const std::vector<Part>& parts) {
  std::vector<std::string> solved;
  for (const Part& part : parts) {
    if (part.is_hung_point()) continue;
    solved.push_back(fmt::format("{}", fmt::join(names(problem, part.points), " ")));
    if (!part.base.empty()) solved.back() += fmt::format(" on {}", fmt::join(names(problem, part.base), " "));
  }
  if (solved.size() < 2) return "";
  return row("solved apart", fmt::format("{} parts: {}", solved.size(), join(solved)));
}

std::string plan_text(const std::optional<ConstructionPlan>& plan) {
  if (!plan) return row("construction plan", "none: it starts from a sketch of points");
  const std::string removed = plan->removed.empty() ? "" : " in place of " + join(plan->removed);
  std::string text =
      row("construction plan", fmt::format("{}; driving parameters: {}{}", plan->given ? "given" : "derived",
                                           plan->removed.size(), removed));
  for (const std::string& instruction : plan->instructions) text += "  " + instruction + "\n";
  return text;
}

std::string strategies_text(const std::vector<StrategyVerdict>& strategies) {
  std::string text = "strategies\n";
  for (const StrategyVerdict& verdict : strategies)
    text += row("  " + verdict.name, verdict.why_not ? "does not apply: " + *verdict.why_not : "applies");
  return text;
}

std::string published_text(const std::vector<PublishedFigure>& published) {
  if (published.empty()) return "";
  std::string text = "published\n";
  for (const PublishedFigure& figure : published) {
    const std::string convention = figure.convention.empty() ? "" : fmt::format(" ({})", figure.convention);
    const std::string by = figure.by.empty() ? "" : fmt::format(", by {}", figure.by);
    text += fmt::format("  {}{}: {}, {}{}\n", figure.quantity, convention, figure.value, figure.source, by);
  }
  return text;
}

std::string text_description(const Description& description) {
  const Instance& instance = description.instance;
  const ProblemStatement& problem = instance.problem;
  std::string text = instance.id + (instance.title.empty() ? "" : ": " + instance.title) + "\n";
  text += row("entities", entities_text(problem));
  if (const auto fixed = fixed_names(problem); !fixed.empty()) text += row("fixed", join(fixed));
  text += row("degrees of freedom", freedom_text(description.structure));
  text += row("reference", reference_text(description));
  text += row("sketch", sketch_text(problem));
  if (description.positive_support) text += row("lengths >= 0", support_text(*description.positive_support));
  text += row("core to solve", core_text(problem, description.reduction));
  text += parts_text(problem, description.parts);
  text += row("placed after it", placed_text(problem, description.reduction));
  text += counts_text(problem, description.counts);
  return text + plan_text(description.plan) + strategies_text(description.strategies) +
         published_text(instance.published);
}

ExitCode draw(const Instance& instance, const std::string& file) {
  require_another_file(file, instance.origin);
  if (const auto reason = why_no_tree(instance)) {
    std::cerr << "gcsbench: no tree is drawn: " << *reason << '\n';
    return ExitCode::not_solved;
  }
  Output(file).commit(draw_tree(instance).svg);
  return ExitCode::done;
}

ExitCode run(const DescribeArguments& arguments) {
  const Instance instance = load_instance(arguments.instance);
  if (!arguments.tree.empty()) return draw(instance, arguments.tree);
  const Description description = describe(instance);
  std::cout << (arguments.json ? json_description(description) : text_description(description));
  return ExitCode::done;
}

}  // namespace

void add_describe_command(CLI::App& app, Invocation& invocation) {
  const auto arguments = std::make_shared<DescribeArguments>();
  CLI::App* command = app.add_subcommand("describe", "What is known of an instance before solving it");
  add_instance_argument(*command, arguments->instance);
  command->add_flag("--json", arguments->json, "As JSON");
  command
      ->add_option(
          "--tree", arguments->tree,
          "Draw the plan's interpretation tree, as SVG, in place of a description; - is standard output")
      ->check(output_name())
      ->type_name("FILE")
      ->excludes("--json");
  command->footer(
      "The tree holds every choice between the two intersections of an instruction, at the given\n"
      "lengths and with the driving parameters of the sketch, and the figures that come out.\n"
      "\nExamples:\n  gcsbench describe disulfide --json\n  gcsbench describe qk33 --tree qk33.svg\n");
  command->callback(
      [&invocation, arguments] { invocation.action = [arguments] { return run(*arguments); }; });
}

}  // namespace gcs
