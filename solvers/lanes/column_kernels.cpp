#include "solvers/lanes/column_kernels.hpp"

namespace gcs {

ColumnKernels column_kernels(InstructionSet set) {
#ifdef GCS_X86
  if (set == InstructionSet::avx512) return avx512_column_kernels();
  if (set == InstructionSet::avx2) return avx2_column_kernels();
#endif
  static_cast<void>(set);
  return portable_column_kernels();
}

}  // namespace gcs
