#include "solvers/lanes/lane_functions.hpp"

namespace gcs {

LaneFunctions lane_functions(InstructionSet set) {
#ifdef GCS_X86
  if (set == InstructionSet::avx512) return avx512_lane_functions();
  if (set == InstructionSet::avx2) return avx2_lane_functions();
#endif
  static_cast<void>(set);
  return portable_lane_functions();
}

}  // namespace gcs
