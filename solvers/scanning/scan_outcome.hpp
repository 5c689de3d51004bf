#pragma once
/// What the subdivision of a plan's angles finds, and what it leaves undecided.

#include <array>
#include <cstdint>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// A range of angles on which some branch could not be decided.
struct UndecidedPiece {
  std::vector<std::array<double, 2>> ranges;  ///< one per angle, in radians
  Figure figure;  ///< in the plan's frame: its middle, or where Newton's method goes from there
};

/// A proven solution, in the plan's frame.
struct ScanSolution {
  Figure figure;
  double error = 0;  ///< bound on the distance of each point from its place, in the scene's unit
};

struct ScanOutcome {
  enum class End { complete, too_many_cells, too_many_undecided, stopped };
  End end = End::complete;
  std::vector<ScanSolution> solutions;  ///< distinct
  std::vector<UndecidedPiece> undecided;
  std::int64_t cells = 0;
  double share = 0;        ///< of the whole that is decided, roughly
  std::int64_t boxes = 0;  ///< to which Krawczyk's test was put
  std::int64_t newton_iterations = 0;
};

}  // namespace gcs
