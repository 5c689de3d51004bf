#include "harness/results/follow_io.hpp"

#include <cmath>
#include <utility>

#include "harness/base/document_text.hpp"
#include "solvers/reading/figure_json.hpp"

namespace gcs {
namespace {

JsonValue figure_value(const ProblemStatement& problem, const Figure& figure) {
  JsonMembers members{{"points", json_points(problem, figure)}, {"lines", json_lines(problem, figure)}};
  if (!problem.planes.empty()) members.emplace_back("planes", json_planes(problem, figure));
  return json_object(std::move(members));
}

JsonValue range_value(double low, double high) { return json_array({json_number(low), json_number(high)}); }

JsonValue changes_value(const ChangedValues& changes) {
  JsonMembers members;
  for (const ChangedValue& change : changes)
    members.emplace_back(change.id, parse_json(change.value.text(), change.id));
  return json_object(std::move(members));
}

JsonValue fold_value(const Followed& leg) {
  JsonMembers values;
  for (const FoldValue& value : leg.values) values.emplace_back(value.id, range_value(value.low, value.high));
  return json_object(
      {{"t", range_value(leg.fold.low, leg.fold.high)}, {"values", json_object(std::move(values))}});
}

JsonValue beyond_value(const ProblemStatement& problem, const Answer& answer) {
  const auto crossing_value = [&](const AssessedCrossing& crossing) {
    return json_object({{"solution", json_or_null(crossing.solution, json_number)},
                        {"direction", json_number(crossing.direction)}});
  };
  const auto solution_value = [&](const AssessedSolution& solution) {
    return figure_value(problem, solution.placement());
  };
  return json_object({{"status", json_text(std::string(word(answer.status)))},
                      {"reason", json_text(answer.reason)},
                      {"mode", json_text(answer.options.at("mode"))},
                      {"path", json_array_of(answer.crossings, crossing_value)},
                      {"solutions", json_array_of(answer.solutions, solution_value)}});
}

JsonValue leg_value(const ProblemStatement& problem, const ChangedValues& changes, const Followed& leg) {
  const bool folds = leg.end == ArcEnd::folds, has_figure = folds || leg.end == ArcEnd::reached;
  return json_object(
      {{"to", changes_value(changes)},
       {"end", json_text(std::string(word(leg.end)))},
       {"reason", json_text(leg.reason)},
       {"proven", json_boolean(leg.proven)},
       {"why_unproven", json_text(leg.why_unproven)},
       {"figure", has_figure ? figure_value(problem, leg.figure) : json_null()},
       {"error_bound", json_or_null(leg.error, json_number)},
       {"fold", folds ? fold_value(leg) : json_null()},
       {"beyond", json_or_null(leg.beyond, [&](const Answer& a) { return beyond_value(problem, a); })}});
}

}  // namespace

std::string follow_text(const Instance& instance, const FollowedPolyline& polyline) {
  return document_text("gcsbench-follow/1", [&](DocumentWriter& document) {
    document.member("instance", instance.document);
    document.member("from", figure_value(instance.problem, polyline.from));
    std::size_t place = 0;
    document.list("legs", polyline.legs, [&](const Followed& leg) {
      return leg_value(instance.problem, polyline.vertices[place++], leg);
    });
  });
}

}  // namespace gcs
