/// The tracker's lanes for one instruction set: this file is compiled with that set's flags.
#define GCS_LANES avx512_lanes
#include "solvers/complex_tracking/lane_kernel.hpp"

namespace gcs {

std::unique_ptr<LaneTracker> make_avx512_lane_tracker(const SquareSystem& system,
                                                      const Elimination& elimination,
                                                      const TrackingOptions& options) {
  return std::make_unique<avx512_lanes::KernelTracker<avx512_lanes::Lanes>>(system, elimination, options);
}

}  // namespace gcs
