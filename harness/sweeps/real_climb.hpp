#pragma once
/// From lengths to others at which more realisations of a graph are real.

#include <cstddef>
#include <cstdint>
#include <functional>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

/// Lengths, and how many of the solutions there, up to reflection, are real.
struct CountedLengths {
  ProblemStatement problem;
  std::size_t real = 0;
  std::size_t all = 0;
};

struct ClimbSettings {
  std::uint64_t seed = 1;  ///< of the steps that are random
  std::function<bool()> stopped = [] { return false; };
  std::function<void(const CountedLengths&)> progress = [](const CountedLengths&) {
  };  ///< hears of every record
};

/// The most real solutions that were met until all are real or `stopped()`, and how many scenes that took.
struct Climb {
  std::size_t real_at_start = 0;
  CountedLengths top;
  int scenes = 0;
};

/// Climbs from the lengths of `start` to others, squares in twelve decimal digits, from one fold to the next: of the pairs of
/// conjugate solutions z, z̄ the one that is the nearest to being real, in the ratio of |Im z|²/|z|² to its gradient by the
/// logarithms of the squared lengths, is led across its fold by the shortest step that also keeps pairs of real solutions,
/// and real ones and their mirror images, so far apart that they do not meet. Where no such step pays, Σ √(|Im z|/|z|) is
/// made smaller, or a random step is taken. Every scene is solved for all complex solutions by `monodromy`, from those at
/// one choice of random lengths.
/// Precondition: distances between points only, none of which are given positions. Throws std::runtime_error where the
/// solutions at the first lengths are not found.
Climb climb_to_real(const ProblemStatement& start, const ClimbSettings& settings);

}  // namespace gcs
