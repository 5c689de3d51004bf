#pragma once
/// Reads gcsbench-result/1, as far as it speaks of the solutions, whoever wrote it.

#include <string>

#include "harness/instances/instance_lookup.hpp"
#include "harness/results/result_counts.hpp"
#include "harness/solving/solve_run.hpp"

namespace gcs {

struct StoredResult {
  Instance instance;
  Scene scene;
  Answer answer = {};        ///< strategy, status, reason, claim, solutions, escaping, crossings and counts
  ResultCounts stated = {};  ///< the counts in the words of the file
};

/// The answer of an external program about `scene`: a result of which nothing but `solutions` has to be there.
/// `source` is for messages. A solution without the member `real` is real unless its coordinates are pairs. Members that it does not know are passed over. Throws InputError.
Answer parse_answer(const std::string& text, const Scene& scene, const std::string& source);

/// The result in `text`; `file` is for messages. Members that it does not know are passed over.
/// Throws InputError.
StoredResult parse_result(const std::string& text, const std::string& file);

/// What the file of that name holds; "-" is standard input. Throws InputError.
std::string read_result(const std::string& argument);

/// The result in the file of that name; "-" is standard input. Throws InputError.
StoredResult load_result(const std::string& argument);

}  // namespace gcs
