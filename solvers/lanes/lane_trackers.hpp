#pragma once
/// Trackers in lanes, for systems of squares and of monomials.

#include "solvers/lanes/instruction_set.hpp"
#include "solvers/lanes/lane_tracker.hpp"

namespace gcs {

/// Precondition: the instruction set is available. `system` and `elimination` are referred to, not copied.
std::unique_ptr<LaneTracker> make_lane_tracker(InstructionSet set, const SquareSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options);
std::unique_ptr<LaneTracker> make_lane_tracker(InstructionSet set, const MonomialSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options);

/// In arithmetic of about 106 bits: the same steps, for paths that doubles cannot follow. Precondition as above.
std::unique_ptr<LaneTracker> make_wide_tracker(InstructionSet set, const SquareSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options);
std::unique_ptr<LaneTracker> make_wide_tracker(InstructionSet set, const MonomialSystem& system,
                                               const Elimination& elimination,
                                               const TrackingOptions& options);

}  // namespace gcs
