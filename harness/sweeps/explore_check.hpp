#pragma once
/// What explore reaches of all real solutions of a scene, and what those that it misses have in common.
///
/// Real solutions and the curves between them, with one value released for each, are a graph; explore walks all of a component
/// once it has one solution there.

#include <cstdint>
#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs {

struct ExploreReach {
  std::size_t solutions = 0;  ///< of the real ones
  std::int64_t curves = 0;    ///< walked
  double cpu_s = 0;
};

struct ExploreVerdict {
  std::size_t real = 0;                 ///< classes that monodromy finds
  bool is_proven = false;               ///< that they are there, and no others
  std::string why_not;                  ///< they are not known: the rest says nothing
  ExploreReach from_sketch;             ///< without random starts
  ExploreReach with_starts;             ///< with those of the default
  std::vector<std::size_t> components;  ///< how many solutions each holds, largest first
  std::size_t unexpected = 0;           ///< solutions that explore finds and monodromy does not

  bool reaches_all() const { return with_starts.solutions == real; }
};

/// `time_limit_s` is for each solve. Precondition: there is a sketch.
ExploreVerdict check_explore(const ProblemStatement& problem, double time_limit_s);

/// How many real solutions were found in how much processor time.
struct FoundSoFar {
  double cpu_s = 0;
  std::size_t solutions = 0;
};

/// Of a strategy that is stopped after each of these times on the wall, in seconds; without reduction, on one thread.
std::vector<FoundSoFar> found_after(const ProblemStatement& problem, const std::string& strategy,
                                    const std::vector<double>& times_s);

}  // namespace gcs
