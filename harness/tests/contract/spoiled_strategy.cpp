#include "harness/tests/contract/spoiled_strategy.hpp"

#include <algorithm>

namespace gcs::contract {

StrategyEntry sound_strategy() {
  const auto all = all_strategies();
  return *std::find_if(all.begin(), all.end(),
                       [](const StrategyEntry& entry) { return entry.name == "full-space"; });
}

}  // namespace gcs::contract
