/// The tracker's lanes for any machine, and one lane of higher precision.
#define GCS_LANES portable_lanes
#include "solvers/complex_tracking/lane_kernel.hpp"

namespace gcs {

std::unique_ptr<LaneTracker> make_portable_lane_tracker(const SquareSystem& system,
                                                        const Elimination& elimination,
                                                        const TrackingOptions& options) {
  return std::make_unique<portable_lanes::KernelTracker<portable_lanes::Lanes>>(system, elimination, options);
}

std::unique_ptr<LaneTracker> make_wide_tracker(const SquareSystem& system, const Elimination& elimination,
                                               const TrackingOptions& options) {
  return std::make_unique<portable_lanes::KernelTracker<portable_lanes::Wide>>(system, elimination, options);
}

}  // namespace gcs
