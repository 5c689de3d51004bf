#pragma once
/// The instruction sets of this machine, for what is to have the same bits with all of them.

#include <vector>

#include "solvers/lanes/instruction_set.hpp"

namespace gcs::samples {

inline std::vector<InstructionSet> available_sets() {
  std::vector<InstructionSet> sets{InstructionSet::portable, InstructionSet::avx2, InstructionSet::avx512};
  std::erase_if(sets, [](InstructionSet set) { return !is_available(set); });
  return sets;
}

}  // namespace gcs::samples
