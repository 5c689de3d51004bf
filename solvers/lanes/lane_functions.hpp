#pragma once
/// What is compiled once for each instruction set.

#include <memory>
#include <span>

#include "solvers/lanes/column_kernels.hpp"
#include "solvers/lanes/instruction_set.hpp"

namespace gcs {

struct DifferenceMatrix;
struct Elimination;
class LaneTracker;
struct MonomialSystem;
struct PointCoordinates;
struct SquareSystem;
struct TrackingOptions;

template <class System>
using LaneTrackerFactory = std::unique_ptr<LaneTracker> (*)(const System&, const Elimination&,
                                                            const TrackingOptions&);

/// See make_lane_tracker and make_wide_tracker.
struct LaneTrackerFactories {
  LaneTrackerFactory<SquareSystem> for_squares;
  LaneTrackerFactory<MonomialSystem> for_monomials;
  LaneTrackerFactory<SquareSystem> wide_for_squares;
  LaneTrackerFactory<MonomialSystem> wide_for_monomials;
};

struct LaneFunctions {
  LaneTrackerFactories trackers;
  /// Writes one number for each figure; see normalised_conditions.
  void (*conditions)(const DifferenceMatrix&, std::span<const PointCoordinates>, double*);
  ColumnKernels columns;
};

/// Precondition: the instruction set is available.
LaneFunctions lane_functions(InstructionSet set = widest_instruction_set());

LaneFunctions portable_lane_functions();
#ifdef GCS_X86
LaneFunctions avx2_lane_functions();
LaneFunctions avx512_lane_functions();
#endif

}  // namespace gcs
