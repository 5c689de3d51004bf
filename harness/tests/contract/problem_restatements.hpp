#pragma once
/// The same problem stated otherwise: what a solver finds must not depend on it.

#include <random>
#include <string>
#include <vector>

#include "solvers/problem/problem_statement.hpp"

namespace gcs::contract {

struct Restatement {
  std::string name;
  ProblemStatement problem;
  std::vector<int> point_now;  ///< by the original's points: the index in `problem`
  bool is_mirrored = false;    ///< positions have the other sign of x
  int unit_exponent = 0;       ///< every length is 2^unit_exponent times as long
  bool is_exact = false;       ///< no bit of a computation in the scene's unit may change

  /// The figure of the original problem that a figure of `problem` stands for; both in the units of their
  /// scenes.
  Figure original(const Figure& figure) const;
};

/// Points in a random order under new names: `relabelled`.
Restatement relabelled(const ProblemStatement& problem, std::mt19937_64& random);
/// Constraints in a random order; the bent one stays the bent one: `constraints permuted`.
Restatement constraints_permuted(const ProblemStatement& problem, std::mt19937_64& random);
/// Every given position with the other sign of x: `mirrored`.
Restatement mirrored(const ProblemStatement& problem);
/// (a, b) as (b, a) in every constraint: `ends swapped`.
Restatement ends_swapped(const ProblemStatement& problem);
/// Every length times 2^exponent: `scaled`. Precondition: lengths are written without an exponent.
Restatement scaled(const ProblemStatement& problem, int exponent);

/// The problem with the lengths of a random placement, every point anywhere in a box about its place in the
/// sketch, a third of the longest length wide; a random constraint is bent, a little. Precondition: a sketch,
/// no lines and no fixed positions.
ProblemStatement with_random_targets(ProblemStatement problem, std::mt19937_64& random);

/// decimal · 2^exponent as a decimal, exactly. Precondition: `decimal` is digits with at most one point.
std::string times_power_of_two(const std::string& decimal, int exponent);

}  // namespace gcs::contract
