#pragma once
/// General scenes of the families on their way to a file, with values of many digits.

#include <string>
#include <string_view>
#include <vector>

#include "harness/instances/family_draft.hpp"

namespace gcs {

struct NamedPoint {
  std::string name;
  ExactPoint at;
};
using NamedPoints = std::vector<NamedPoint>;

struct GeneralDraft {
  int dimension = 3;
  std::vector<std::string> points = {};
  std::vector<std::string> lines = {};
  std::vector<std::string> planes = {};
  std::vector<std::string> bodies = {};       ///< as JSON, `"name": {…}`
  std::vector<std::string> constraints = {};  ///< as JSON
};

std::vector<std::string> names_of(const NamedPoints& points);
const ExactPoint& place_of(const NamedPoints& points, std::string_view name);

LongDecimal dot(const ExactPoint& a, const ExactPoint& b);
ExactPoint cross(const ExactPoint& a, const ExactPoint& b);
ExactPoint difference(const ExactPoint& a, const ExactPoint& b);

/// `[x, y]` or `[x, y, z]`.
std::string coordinates_text(const ExactPoint& point, int dimension);
/// `"name": {…}` of points.
std::string body_text(std::string_view name, const NamedPoints& points, int dimension);

/// A constraint without a value, and with one: "length", "squared" or "cosine". An operand is a name or, with its brackets
/// and quotes, a segment.
std::string relation_text(std::string_view type, std::string_view a, std::string_view b);
std::string relation_text(std::string_view type, std::string_view a, std::string_view b,
                          std::string_view member, const LongDecimal& value);
/// The squared distance that the points have.
std::string distance_text(const NamedPoints& points, std::string_view a, std::string_view b);

/// The text of gcsbench-instance/2.
std::string text_of(const std::string& id, const GeneralDraft& draft);

}  // namespace gcs
