#pragma once
/// Theoretical counts as text and as JSON, and the rows of such texts.

#include <string>
#include <string_view>
#include <vector>

#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/reading/json_document.hpp"

namespace gcs {

/// A label and what it says, on one line.
std::string row(std::string_view label, const std::string& text);

/// A row for the exact number and one for the bound, each in all conventions or with the reason why there is
/// none.
std::string counts_text(const ProblemStatement& problem, const TheoreticalCounts& counts);

/// The members `exact` and `bound`, objects by convention or null, and `why_no_exact` and `why_no_bound`,
/// sentences or null. A bound has its `reference` and, empty unless it is of one, the bodies of its `ring`, and, if
/// there are such, the points `at_infinity` of solutions that it is less.
JsonValue counts_value(const ProblemStatement& problem, const TheoreticalCounts& counts);

/// The entities of a bound by name.
struct BoundNames {
  std::vector<std::string> reference;
  std::vector<std::vector<std::string>> ring;
  int parts = 1;
  std::string theorem{};                                ///< that gives the bound; empty: none
  std::vector<std::vector<std::string>> at_infinity{};  ///< see CountBound
};

BoundNames names_of(const ProblemStatement& problem, const CountBound& bound);

/// Which bound it is, of what.
std::string bound_origin(const BoundNames& names);

}  // namespace gcs
