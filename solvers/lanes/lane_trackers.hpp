#pragma once
/// Which function makes the trackers of which lanes; each is compiled for its own instruction set.

#include "solvers/lanes/lane_tracker.hpp"

namespace gcs {

enum class InstructionSet { portable, avx2, avx512 };

std::string_view name(InstructionSet set);
/// Whether this machine and this build have it.
bool is_available(InstructionSet set);
/// The widest that is available.
InstructionSet widest_instruction_set();

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

template <class System>
using LaneTrackerFactory = std::unique_ptr<LaneTracker> (*)(const System&, const Elimination&,
                                                            const TrackingOptions&);

struct LaneTrackerFactories {
  LaneTrackerFactory<SquareSystem> for_squares;
  LaneTrackerFactory<MonomialSystem> for_monomials;
  LaneTrackerFactory<SquareSystem> wide_for_squares;
  LaneTrackerFactory<MonomialSystem> wide_for_monomials;
};

LaneTrackerFactories portable_lane_trackers();
#ifdef GCS_X86
LaneTrackerFactories avx2_lane_trackers();
LaneTrackerFactories avx512_lane_trackers();
#endif

}  // namespace gcs
