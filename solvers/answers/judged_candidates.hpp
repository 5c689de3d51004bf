#pragma once
/// The candidates of a report, each judged for itself, and the list of the solutions that they are.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "solvers/answers/assessed_solution.hpp"
#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs {

/// Above this, a double solution and two solutions that rounding cannot tell apart look the same.
inline constexpr double singular_condition = 1e12;

/// A candidate that can be judged, with everything that does not depend on the others.
struct Judged {
  std::size_t candidate = 0;  ///< which one
  Figure representative;      ///< in the scene's unit
  double condition = 0;
  int multiplicity = 1;
  double error = 0;  ///< the candidate's
  SignVerdict signs{};
};

/// Proven errors of figures in the scene's unit and frame, as of candidates; no number at all where none are to be proven.
using ErrorsOf = std::function<std::vector<double>(const std::vector<Figure>&)>;

/// `judge`: of the scene. One for each candidate; nothing for what lacks an entity, is not finite or has no multiplicity.
/// The same for any number of threads ≥ 1. `takes_figures`: candidates are left without, as long lists are large.
std::vector<std::optional<Judged>> judged_candidates(const Scene& scene, const FigureJudge& judge,
                                                     std::vector<Candidate>& candidates, bool takes_figures,
                                                     int threads);

struct ListedSolutions {
  std::vector<AssessedSolution> solutions;  ///< one for each class, in their order
  std::vector<int> solution_of;             ///< of each judged candidate
};

/// Real solutions first, those as stated before the others; with the largest multiplicity that was reported for a member
/// of the class. Takes the representatives of `judged`, as long lists are large. The same for any number of threads ≥ 1.
/// `errors_of`: asked where some candidates are taken for the same class; may be empty.
ListedSolutions list_solutions(const Scene& scene, const FigureJudge& judge, std::vector<Judged>& judged,
                               const ErrorsOf& errors_of, int threads);

}  // namespace gcs
