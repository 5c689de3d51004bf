#include "harness/solving/counts_view.hpp"

#include <fmt/format.h>

#include "solvers/reading/json_build.hpp"
#include "solvers/solving/answer.hpp"

namespace gcs {
namespace {

std::string in_conventions(const ProblemStatement& problem, const SolutionCount& count) {
  if (problem.is_general())
    return fmt::format("{} {}", readable(count.up_to_reflection()), word(convention_of(problem)));
  return fmt::format("{} in the fixed frame, {} up to reflection, {} with all signs",
                     readable(count.fixed_frame), readable(count.up_to_reflection()),
                     readable(count.all_signs()));
}

std::string exact_text(const ProblemStatement& problem, const TheoreticalCounts& counts) {
  return counts.exact ? "exactly " + in_conventions(problem, *counts.exact)
                      : "not known: " + counts.why_no_exact;
}

std::string bound_text(const ProblemStatement& problem, const TheoreticalCounts& counts) {
  if (!counts.bound) return "none: " + counts.why_no_bound;
  return fmt::format("at most {}; {}", in_conventions(problem, counts.bound->count),
                     bound_origin(names_of(problem, *counts.bound)));
}

/// Of a scene of more than distances no reference coordinates are unknowns, and mirror images may be two.
JsonMembers convention_members(const ProblemStatement& problem, const SolutionCount& count) {
  if (problem.is_general())
    return {{"fixed_frame", json_count(count.fixed_frame)},
            {"up_to_reflection", convention_of(problem) == Convention::up_to_reflection
                                     ? json_count(count.up_to_reflection())
                                     : json_null()},
            {"all_signs", json_null()}};
  return {{"fixed_frame", json_count(count.fixed_frame)},
          {"up_to_reflection", json_count(count.up_to_reflection())},
          {"all_signs", json_count(count.all_signs())}};
}

JsonValue bound_value(const ProblemStatement& problem, const CountBound& bound) {
  JsonMembers members = convention_members(problem, bound.count);
  const BoundNames names = names_of(problem, bound);
  members.emplace_back("reference", json_texts(names.reference));
  const auto texts = [](const std::vector<std::string>& some) { return json_texts(some); };
  members.emplace_back("ring", json_array_of(names.ring, texts));
  members.emplace_back("parts", json_number(bound.parts));
  if (!bound.theorem.empty()) members.emplace_back("theorem", json_text(bound.theorem));
  if (!names.at_infinity.empty())
    members.emplace_back("at_infinity", json_array_of(names.at_infinity, texts));
  return json_object(std::move(members));
}

std::string list_of(const std::vector<std::vector<std::string>>& sets, const char* separator) {
  std::vector<std::string> texts;
  for (const std::vector<std::string>& names : sets)
    texts.push_back(fmt::format("{}", fmt::join(names, " ")));
  return fmt::format("{}", fmt::join(texts, separator));
}

JsonValue reason_value(const std::string& reason) { return reason.empty() ? json_null() : json_text(reason); }

}  // namespace

std::string row(std::string_view label, const std::string& text) {
  return fmt::format("{:<20}{}\n", label, text);
}

std::string counts_text(const ProblemStatement& problem, const TheoreticalCounts& counts) {
  return row("complex solutions", exact_text(problem, counts)) +
         row("upper bound", bound_text(problem, counts));
}

JsonValue counts_value(const ProblemStatement& problem, const TheoreticalCounts& counts) {
  const auto exact_value = [&](const SolutionCount& count) {
    return json_object(convention_members(problem, count));
  };
  const auto value_of_bound = [&](const CountBound& bound) { return bound_value(problem, bound); };
  return json_object({{"exact", json_or_null(counts.exact, exact_value)},
                      {"why_no_exact", reason_value(counts.why_no_exact)},
                      {"bound", json_or_null(counts.bound, value_of_bound)},
                      {"why_no_bound", reason_value(counts.why_no_bound)}});
}

BoundNames names_of(const ProblemStatement& problem, const CountBound& bound) {
  const auto names = [&](const std::vector<int>& entities) {
    std::vector<std::string> result;
    for (const int entity : entities) result.push_back(problem.name(entity));
    return result;
  };
  BoundNames all{names(bound.reference), {}, bound.parts, bound.theorem};
  for (const std::vector<int>& body : bound.ring) all.ring.push_back(names(body));
  for (const std::vector<int>& points : bound.at_infinity) all.at_infinity.push_back(names(points));
  return all;
}

std::string bound_origin(const BoundNames& names) {
  if (names.parts > 1) return fmt::format("product of the bounds of {} parts", names.parts);
  if (!names.theorem.empty()) return names.theorem;
  if (names.ring.empty() && names.reference.empty())
    return "Bézout bound of a cubic and a quartic in the line's direction";
  if (!names.ring.empty())
    return fmt::format("ring of {} hinged bodies: {}", names.ring.size(), list_of(names.ring, ", "));
  const std::string all = fmt::format("m-Bézout bound with {} held fixed", fmt::join(names.reference, ", "));
  if (names.at_infinity.empty()) return all;
  return fmt::format("{}, less solutions with {} at infinity at all lengths", all,
                     list_of(names.at_infinity, " or "));
}

}  // namespace gcs
