#pragma once
/// How far an answer is from the solutions that are known by proof.

#include <cstdint>
#include <optional>
#include <vector>

#include "harness/results/reference_list.hpp"
#include "harness/solving/solve_run.hpp"
#include "solvers/certificates/figure_distance.hpp"

namespace gcs {

/// An error of up to so many times the condition number times the unit roundoff is explained by the
/// condition.
inline constexpr double explained_quotient = 10;

/// Errors are relative to the scene's size; see figure_distance.hpp for what they measure.
struct Accuracy {
  std::uint64_t met = 0;  ///< reference solutions that the answer has
  /// Those that its claim covers (some real, or of a component: all real ones) and that it has not; empty: not known.
  std::optional<std::uint64_t> missed;
  std::uint64_t spurious = 0;  ///< listed solutions that are none, or that stand there twice
  double largest_error = 0;    ///< over the solutions met
  double median_error = 0;
  double largest_condition = 0;  ///< as assessed, of the solutions met
  /// Of an error over the condition number (1 at least) times the unit roundoff.
  double largest_quotient = 0;

  /// It lists what is none, or has not what it claims to find; who claims some real solutions promises none
  /// in particular, and which ones a component has the reference does not tell.
  bool contradicts(Claim claim) const {
    const bool names_all = claim != Claim::some_real && claim != Claim::all_real_of_component;
    return spurious > 0 || (names_all && missed.value_or(0) > 0);
  }
  bool operator==(const Accuracy&) const = default;
};

/// Holds answers about one scene against its reference.
class AccuracyJudge {
 public:
  /// Keeps a reference to the scene.
  AccuracyJudge(const Scene& scene, ReferenceList reference);

  /// Of the solutions in doubles or, where the run holds them, of those refined to `digits`. A solution of
  /// multiplicity m stands for up to m that doubles do not tell apart. Throws std::runtime_error when a
  /// solution of the reference cannot be proven to so many digits.
  Accuracy judge(const SolveRun& run, int digits) const;
  /// The run has searched for real solutions and gave up, and the reference proves that there are none.
  bool is_search_in_vain(const SolveRun& run) const;

 private:
  struct Match {
    int known = -1;  ///< −1: none
    AxisSigns signs{1, 1, 1};
  };

  Match match(const AssessedSolution& solution, const std::vector<bool>& met) const;
  bool is_scored(const Figure& figure) const;
  bool is_expected(std::size_t known, Claim claim) const;
  std::optional<std::uint64_t> missed(const std::vector<bool>& met, Claim claim) const;
  double error(const SolveRun& run, std::size_t solution, const Match& match, int digits) const;

  const Scene& scene_;
  ReferenceList reference_;
  std::vector<AxisSigns> images_;
  std::vector<double> reach_;  ///< a figure further from the solution than this is another one or none
};

}  // namespace gcs
