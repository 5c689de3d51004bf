#include "harness/descriptions/description_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "harness/solving/counts_view.hpp"
#include "harness/solving/frame_view.hpp"
#include "harness/solving/solve_run.hpp"

namespace gcs {
namespace {

std::string join(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

std::string entities_text(const ProblemStatement& problem) {
  std::string text = fmt::format("{} points", problem.points.size());
  const auto append = [&](std::size_t count, std::string_view one, std::string_view several) {
    if (count > 0) text += fmt::format(", {} {}", count, count == 1 ? one : several);
  };
  append(problem.lines.size(), "line", "lines");
  append(problem.planes.size(), "plane", "planes");
  append(problem.bodies.size(), "body", "bodies");
  return text + (problem.dimension == 2 ? " in the plane" : " in space");
}

std::string freedom_text(const Structure& structure) {
  const bool rigid = structure.generic_rank == structure.unknowns;
  return fmt::format("{} unknown coordinates, {} constraints of generic rank {}: {}", structure.unknowns,
                     structure.constraints, structure.generic_rank, rigid ? "rigid" : "not rigid");
}

std::string freedom_text(const GeneralFacts& facts) {
  if (facts.why_no_system) return "not counted: " + *facts.why_no_system;
  return fmt::format("{} unknowns, {} equations: {}", facts.unknowns, facts.equations,
                     facts.why_not_rigid ? "not rigid: " + *facts.why_not_rigid : "rigid");
}

std::string bodies_text(const ProblemStatement& problem) {
  std::string text;
  for (const RigidBody& body : problem.bodies) {
    std::vector<int> entities;
    for (const BodyElement& element : body.elements) entities.push_back(element.entity);
    text += row("  " + body.name, join(names(problem, entities)));
  }
  return text;
}

std::string frame_text(const Description& description) {
  std::vector<std::string> parts;
  for (const auto& [part, name] : description.frame) parts.push_back(part + " " + name);
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

std::string plan_text(const ConstructionPlan& plan) {
  if (!plan.why_none.empty()) return row("construction plan", "none: " + plan.why_none);
  const std::string removed = plan.removed.empty() ? "" : " in place of " + join(plan.removed);
  std::string text =
      row("construction plan", fmt::format("{}; driving parameters: {}{}", plan.given ? "given" : "derived",
                                           plan.driving_parameters, removed));
  for (const std::string& instruction : plan.instructions) text += "  " + instruction + "\n";
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

/// What only scenes of points, lines in space and distances have, in the middle of a description and at its end.
std::string core_rows(const ProblemStatement& problem, const DistanceFacts& facts) {
  std::string text = row("sketch", sketch_text(problem));
  if (facts.positive_support) text += row("lengths >= 0", support_text(*facts.positive_support));
  text += row("core to solve", core_text(problem, facts.reduction));
  text += parts_text(problem, facts.parts);
  return text + row("placed after it", placed_text(problem, facts.reduction));
}

std::string freedom_rows(const Description& description) {
  const ProblemStatement& problem = description.instance.problem;
  if (const auto& facts = description.distances)
    return row("degrees of freedom", freedom_text(facts->structure)) +
           row("reference", frame_text(description)) + core_rows(problem, *facts);
  return row("degrees of freedom", freedom_text(*description.general)) +
         row("frame", frame_text(description)) +
         row("solutions", fmt::format("counted {}", word(convention_of(problem)))) +
         row("sketch", problem.sketch ? "given" : "none");
}

}  // namespace

std::string text_description(const Description& description) {
  const Instance& instance = description.instance;
  const ProblemStatement& problem = instance.problem;
  std::string text = instance.id + (instance.title.empty() ? "" : ": " + instance.title) + "\n";
  text += row("entities", entities_text(problem)) + bodies_text(problem);
  if (const auto fixed = fixed_names(problem); !fixed.empty()) text += row("fixed", join(fixed));
  text += freedom_rows(description) + counts_text(problem, description.counts) + plan_text(description.plan);
  return text + strategies_text(description.strategies) + published_text(instance.published);
}

}  // namespace gcs
