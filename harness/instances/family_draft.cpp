#include "harness/instances/family_draft.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gcs {
namespace {

/// What is rounded off matters to no double, and to no ε of the families.
constexpr int digits = 50;

std::string point_name(int number) { return fmt::format("\"p{}\"", number + 1); }

std::string entity_name(const Draft& draft, int number) {
  return number < draft.points ? point_name(number) : "\"L\"";
}

bool has_line(const Draft& draft) {
  return std::any_of(draft.edges.begin(), draft.edges.end(),
                     [&](const DraftEdge& edge) { return edge[1] == draft.points; });
}

std::string names_text(const Draft& draft) {
  std::vector<std::string> names;
  for (int i = 0; i < draft.points; ++i) names.push_back(point_name(i));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string constraints_text(const Draft& draft, std::string_view given) {
  std::vector<std::string> constraints;
  for (std::size_t e = 0; e < draft.edges.size(); ++e)
    constraints.push_back(fmt::format(R"({{"id": "a{}", "type": "distance", "between": [{}, {}], "{}": {}}})",
                                      e + 1, entity_name(draft, draft.edges[e][0]),
                                      entity_name(draft, draft.edges[e][1]), given,
                                      draft.squares[e].text(digits)));
  return fmt::format("{}", fmt::join(constraints, ", "));
}

std::string sketch_text(const Draft& draft) {
  std::vector<std::string> entries;
  for (std::size_t i = 0; i < draft.sketch.size(); ++i) {
    const auto& p = draft.sketch[i];
    entries.push_back(point_name(static_cast<int>(i)) +
                      (draft.dimension == 2 ? fmt::format(": [{}, {}]", p[0], p[1])
                                            : fmt::format(": [{}, {}, {}]", p[0], p[1], p[2])));
  }
  return fmt::format("{}", fmt::join(entries, ", "));
}

std::string fixed_text(const Draft& draft) {
  std::vector<std::string> entries;
  for (std::size_t i = 0; i < draft.fixed.size(); ++i) {
    const ExactPoint& p = draft.fixed[i];
    entries.push_back(fmt::format("{}: [{}, {}, {}]", point_name(static_cast<int>(i)), p[0].text(digits),
                                  p[1].text(digits), p[2].text(digits)));
  }
  return fmt::format("{}", fmt::join(entries, ", "));
}

}  // namespace

LongDecimal squared_distance(const ExactPoint& a, const ExactPoint& b) {
  LongDecimal square(0.0);
  for (std::size_t axis = 0; axis < 3; ++axis) square = square + (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return square;
}

Draft measured_at(const std::vector<ExactPoint>& points, Draft draft) {
  draft.squares.clear();
  for (const auto& [a, b] : draft.edges)
    draft.squares.push_back(
        squared_distance(points[static_cast<std::size_t>(a)], points[static_cast<std::size_t>(b)]));
  return draft;
}

std::string text_of(const std::string& id, const Draft& draft, std::string_view given) {
  std::string more;
  if (has_line(draft)) more += ", \"lines\": [\"L\"]";
  if (!draft.fixed.empty()) more += fmt::format(", \"fixed\": {{{}}}", fixed_text(draft));
  if (!draft.sketch.empty()) more += fmt::format(", \"sketch\": {{{}}}", sketch_text(draft));
  if (!draft.interpolation.empty()) more += ", \"interpolation\": " + draft.interpolation;
  return fmt::format(
      R"({{"format": "gcsbench-instance/1", "id": "{}", "dimension": {}, "points": [{}], "constraints": [{}]{}}})",
      id, draft.dimension, names_text(draft), constraints_text(draft, given), more);
}

}  // namespace gcs
