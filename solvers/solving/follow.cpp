#include "solvers/solving/follow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "solvers/reading/changed_value.hpp"
#include "solvers/solving/solve.hpp"

namespace gcs {
namespace {

constexpr const char* source = "follow";

ProblemStatement straight(ProblemStatement problem) {
  problem.interpolation.bends.emplace();
  return problem;
}

/// How the value of that id travels; null where the arc says nothing of it.
const LengthPath* travelling(const ProblemStatement& problem, const StraightArc& arc, const std::string& id) {
  const auto has_id = [&](const auto& one) { return one.id == id; };
  auto number = static_cast<std::size_t>(std::ranges::find_if(problem.constraints, has_id) -
                                         problem.constraints.begin());
  if (number == problem.constraints.size())
    number +=
        static_cast<std::size_t>(std::ranges::find_if(problem.relations, has_id) - problem.relations.begin());
  return number < arc.values.size() && arc.values[number] ? &*arc.values[number] : nullptr;
}

/// An angle's cosine has no unit.
bool is_angle(const ProblemStatement& problem, const std::string& id) {
  return std::ranges::any_of(problem.relations,
                             [&](const Relation& one) { return one.id == id && one.type == "angle"; });
}

/// The values at both ends of the fold's t, and what rounding adds: that of decimals, and of a length that is measured in a
/// figure of this size.
FoldValue value_at_fold(const LengthPath& path, const TimeRange& fold, const std::string& id, double size,
                        int exponent) {
  const double at_low = path.value(fold.low), at_high = path.value(fold.high);
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * size;
  return {id, std::ldexp(std::min(at_low, at_high) - rounding, exponent),
          std::ldexp(std::max(at_low, at_high) + rounding, exponent)};
}

std::vector<FoldValue> values_at_fold(const Scene& scene, const StraightArc& arc,
                                      const ChangedValues& changes) {
  std::vector<FoldValue> values;
  for (const ChangedValue& change : changes)
    if (const LengthPath* path = travelling(scene.problem(), arc, change.id))
      values.push_back(value_at_fold(*path, arc.fold, change.id, scene.size(),
                                     is_angle(scene.problem(), change.id) ? 0 : scene.unit_exponent()));
  return values;
}

Answer solutions_beyond(const Scene& bent, bool proves, std::stop_token stop) {
  const auto on_s = [&](const char* mode) {
    return solve(bent, "full-space", {{"mode", mode}}, {}, {.stop = stop});
  };
  Answer answer = on_s(proves ? "certified" : "fast");
  return proves && answer.status == RunStatus::gave_up ? on_s("fast") : answer;
}

}  // namespace

ProblemStatement with_changes(ProblemStatement problem, const Figure& from, const ChangedValues& changes) {
  problem.sketch = from;
  for (const ChangedValue& change : changes) change_value(problem, change.id, change.value.text(), source);
  return problem;
}

std::string_view word(ArcEnd end) {
  constexpr std::array<std::string_view, 5> words{"reached", "folds", "undecided", "unsupported", "stopped"};
  return words[static_cast<std::size_t>(end)];
}

Followed follow(const Scene& scene, const Figure& from, const ChangedValues& changes,
                const FollowSettings& settings, std::stop_token stop) {
  const ProblemStatement changed = with_changes(scene.problem(), from, changes);
  const Scene moving = Scene::unchecked(straight(changed));
  StraightArc arc = follow_straight(moving, settings.arc, {stop, nullptr});
  Followed followed;
  followed.end = arc.end;
  followed.reason = std::move(arc.reason);
  followed.proven = arc.proven;
  followed.why_unproven = std::move(arc.why_unproven);
  followed.fold = arc.fold;
  followed.work = arc.work;
  if (arc.end == ArcEnd::reached || arc.end == ArcEnd::folds)
    followed.figure = moving.in_file_unit(arc.figure);
  if (std::isfinite(arc.error)) followed.error = std::ldexp(arc.error, moving.unit_exponent());
  if (arc.end != ArcEnd::folds) return followed;
  followed.values = values_at_fold(moving, arc, changes);
  if (settings.beyond)
    followed.beyond = solutions_beyond(Scene::unchecked(changed), settings.arc.prove, stop);
  return followed;
}

Followed follow(const Scene& scene, const ChangedValues& changes, const FollowSettings& settings,
                std::stop_token stop) {
  return follow(scene, *scene.problem().sketch, changes, settings, stop);
}

std::vector<Followed> follow_polyline(const Scene& scene, const Figure& from,
                                      const std::vector<ChangedValues>& vertices,
                                      const FollowSettings& settings, std::stop_token stop) {
  std::vector<Followed> legs;
  for (const ChangedValues& vertex : vertices) {
    legs.push_back(follow(scene, legs.empty() ? from : legs.back().figure, vertex, settings, stop));
    if (legs.back().end != ArcEnd::reached) break;
  }
  return legs;
}

}  // namespace gcs
