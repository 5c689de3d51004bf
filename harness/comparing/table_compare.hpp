#pragma once
/// A comparison of two runs as tables.

#include <string>
#include <vector>

#include "harness/comparing/compare.hpp"
#include "harness/tables/table.hpp"

namespace gcs {

/// Tables with nothing to show are left out.
struct ComparisonTables {
  std::vector<Table> tables;
  std::vector<std::string> lines;  ///< the verdict, one line each
};

/// `before` and `after` name the runs.
ComparisonTables build_comparison(const Comparison& comparison, const std::string& before,
                                  const std::string& after);

}  // namespace gcs
