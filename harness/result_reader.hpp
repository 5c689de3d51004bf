#pragma once
/// Reads gcsbench-result/1, as far as it speaks of the solutions, whoever wrote it.

#include <string>

#include "harness/assess.hpp"
#include "harness/instance_io.hpp"

namespace gcs {

struct StoredResult {
  Instance instance;
  std::string strategy;
  std::string status;  ///< a word of gcsbench-result/1
  std::string claim;   ///< a word of gcsbench-result/1; empty where the file has null
  Assessment listed;   ///< solutions, crossings and counts as listed; nothing else
};

/// The result in `text`; `file` is for messages. Members that it does not know are passed over. Throws
/// InputError.
StoredResult parse_result(const std::string& text, const std::string& file);

}  // namespace gcs
