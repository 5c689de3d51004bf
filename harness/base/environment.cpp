#include "harness/base/environment.hpp"

#include <fstream>

#include "solvers/lanes/instruction_set.hpp"
#include "source_commit.hpp"

namespace gcs {

namespace {

/// "model name : X" in x86 kernels; other machines use other words or none.
std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

Environment capture_environment(int threads) {
  return {cpu_model(),
          GCSBENCH_COMPILER,
          GCSBENCH_CXX_FLAGS,
          GCSBENCH_SOURCE_COMMIT,
          threads,
          std::string(name(widest_instruction_set()))};
}

std::string program_version() { return GCSBENCH_VERSION; }

}  // namespace gcs
