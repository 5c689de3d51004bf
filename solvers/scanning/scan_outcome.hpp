#pragma once
/// What the subdivision of a plan's angles finds, and what it leaves undecided.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solvers/certificates/krawczyk.hpp"
#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// A range of angles on which some branch could not be decided.
struct UndecidedPiece {
  std::vector<std::array<double, 2>> ranges;  ///< one per angle, in radians
  Figure figure;             ///< in the plan's frame: its middle, or where Newton's method goes from there
  std::optional<Box> box{};  ///< of the stage's unknowns: holds the branch, where all of it is placed
};

/// A proven solution, in the plan's frame.
struct ScanSolution {
  Figure figure;
  int multiplicity = 1;
  double error =
      0;  ///< of a simple one: bound on the distance of each point from its place, in the scene's unit
};

struct ScanOutcome {
  enum class End { complete, too_many_cells, too_many_undecided, stopped };
  End end = End::complete;
  std::vector<ScanSolution> solutions;  ///< distinct
  std::vector<UndecidedPiece> undecided;
  bool is_counted = false;  ///< some pieces were decided by counting (undecided_place.hpp)
  std::int64_t cells = 0;
  double share = 0;        ///< of the whole that is decided, roughly
  std::int64_t boxes = 0;  ///< to which Krawczyk's test was put
  std::int64_t newton_iterations = 0;
};

}  // namespace gcs
