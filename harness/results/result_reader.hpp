#pragma once
/// Reads gcsbench-result/1, as far as it speaks of the solutions, whoever wrote it.

#include <optional>
#include <string>
#include <vector>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/result_counts.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/answers/assess.hpp"

namespace gcs {

struct StoredResult {
  Instance instance;
  Scene scene;
  std::string strategy = {};
  RunStatus status = RunStatus::complete;
  std::optional<Claim> claim = {};  ///< empty where the file has null
  Assessment listed = {};           ///< solutions, crossings and counts as listed; nothing else
  ResultCounts stated = {};         ///< the counts in the words of the file
};

/// What an external program answers: a result of which nothing but `solutions` has to be there.
struct ProgramAnswer {
  RunStatus status = RunStatus::complete;
  std::string reason;
  Claim claim = Claim::some_real;
  std::vector<AssessedSolution> solutions;  ///< with figures and multiplicities only
  std::vector<AssessedCrossing> crossings;
};

/// The answer in `text` about `scene`; `source` is for messages. A solution without the member `real` is
/// real unless its coordinates are pairs. Members that it does not know are passed over. Throws InputError.
ProgramAnswer parse_answer(const std::string& text, const Scene& scene, const std::string& source);

/// The result in `text`; `file` is for messages. Members that it does not know are passed over.
/// Throws InputError.
StoredResult parse_result(const std::string& text, const std::string& file);

/// The result in the file of that name; "-" is standard input. Throws InputError.
StoredResult load_result(const std::string& argument);

}  // namespace gcs
