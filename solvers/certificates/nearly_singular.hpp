#pragma once
/// Candidates that are nearly singular, as what they are for the file's own numbers (near_solutions.hpp).

#include <stop_token>
#include <string_view>
#include <vector>

#include "solvers/elements/scene_system.hpp"
#include "solvers/interface/strategy_interface.hpp"
#include "solvers/model/scene.hpp"

namespace gcs {

struct ResolvedCandidates {
  /// Simple ones, proven to be solutions, to be different and to be real or not, with their errors, and
  /// multiple ones.
  std::vector<Candidate> list;
  std::vector<ComplexValues> unknowns;  ///< of these, if simple_solutions_near found them
  bool are_told_apart = true;           ///< the simple ones and those listed, by their coordinates in doubles

  /// With multiplicities.
  int count() const;
  /// Whether these are so many, told apart.
  bool are(int expected) const { return are_told_apart && count() == expected; }
};

/// The solutions next to figures in the scene's frame, of which each stands for so many as its multiplicity;
/// all that are found next to them where these are fewer than `expected`. Fewer come back where it is not
/// found out what they are. `listed`: other, simple solutions. Precondition: certificates reach the scene
/// (scene_equations.hpp), whose lines, if any, are free beside given points.
ResolvedCandidates resolve_nearly_singular(const Scene& scene, const std::vector<Candidate>& nearly_singular,
                                           const std::vector<Candidate>& listed, int expected,
                                           const std::stop_token& stop);

/// The simple solutions of a general scene next to unknowns x, proven and with their errors, at most `count`. Precondition:
/// as many equations as unknowns.
ResolvedCandidates simple_solutions_near(const SceneSystem& system, const ComplexValues& x, int count,
                                         const std::stop_token& stop);

/// Whether doubles tell the simple ones of these candidates apart, as an assessment does it.
bool are_different_classes(const Scene& scene, const std::vector<Candidate>& candidates);

/// Why not all are listed, in words.
inline constexpr std::string_view too_near =
    "solutions lie too near each other to be told apart in doubles, or are not settled";

}  // namespace gcs
