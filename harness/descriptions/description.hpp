#pragma once
/// What is known of an instance before any solving.

#include <optional>
#include <string>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "solvers/counting/theoretical_counts.hpp"
#include "solvers/structure/core_reduction.hpp"
#include "solvers/structure/structure.hpp"
#include "solvers/tracking/path_report.hpp"

namespace gcs {

/// The plan that a path strategy starts with.
struct ConstructionPlan {
  std::string why_none;  ///< empty: there is one
  bool given = false;    ///< by the file; otherwise derived
  std::size_t driving_parameters = 0;
  std::vector<std::string> instructions;  ///< see describe_plan
  std::vector<std::string> removed;  ///< of points: ids of the constraints that driving parameters replace
};

struct StrategyVerdict {
  std::string name;
  std::optional<std::string> why_not;  ///< empty: it applies
};

/// Of points, lines in space and the distances between them.
struct DistanceFacts {
  Structure structure;
  CoreReduction reduction;
  std::vector<Part> parts;                    ///< as the option reduce=on takes the scene apart
  std::optional<TimeRange> positive_support;  ///< empty where S is not defined, or not of points alone
};

/// Of any other scene.
struct GeneralFacts {
  std::optional<std::string> why_no_system;  ///< why there are no equations, and the two counts are 0
  int unknowns = 0;
  int equations = 0;
  std::optional<std::string> why_not_rigid;  ///< empty: it is, at a random figure
};

/// Everything that is shown; text and JSON are two views of it.
struct Description {
  Instance instance;
  std::vector<std::pair<std::string, std::string>> frame;  ///< see frame_parts
  TheoreticalCounts counts;
  ConstructionPlan plan;
  std::vector<StrategyVerdict> strategies;
  std::optional<DistanceFacts> distances;  ///< one of the two
  std::optional<GeneralFacts> general;
};

Description describe(Instance instance);

/// The names of the entities of that number.
std::vector<std::string> names(const ProblemStatement& problem, const std::vector<int>& entities);

}  // namespace gcs
