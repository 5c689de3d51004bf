#pragma once
/// What every strategy promises, as checks that can be pointed at any of them. A check returns what it found
/// wrong, so that tests can also show that a wrong strategy is caught, and by which check.

#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "harness/tests/contract/problem_restatements.hpp"
#include "solvers/interface/strategy_interface.hpp"

namespace gcs::contract {

struct Violation {
  std::string check;  ///< a fixed word per check, given at the check's declaration
  std::string what;   ///< one sentence for a person
};
using Violations = std::vector<Violation>;

/// "check: what", one per line.
std::string in_words(const Violations& violations);

/// A strategy with its options.
struct Subject {
  StrategyEntry entry;
  OptionMap given = {};

  std::string label() const;
  std::unique_ptr<Strategy> make() const { return entry.make(complete_options(entry, given)); }
};

/// True when the strategy, made from the subject, can do the scene.
bool supports(const Subject& subject, const Scene& scene);

/// prepare and solve on a new object.
SolveReport solve_anew(const Subject& subject, const SolveRequest& request);

/// What a solve has done: steps, evaluations and linear systems together.
std::int64_t effort(const WorkCounters& work);

/// `support`: a scene out of reach is refused with a sentence.
Violations check_refusal(const Subject& subject, const Scene& scene);

/// `support`: a scene within reach is solved completely, but that a proof that there is no other real solution may
/// leave undecided what is next to multiple ones; where there are no simple solutions, some real ones may be none. For
/// scenes that are known to be within reach.
Violations check_completion(const SolveReport& report, bool has_simple_solutions = true);

/// What must hold in every report, also in that of a solve that was stopped.
/// `malformed`: indices, directions, sizes and counters are in range.
/// `status`: a status other than complete has a reason, a failed path has a cause, complete has no such path.
/// `residual`: every candidate satisfies the distances to 1e-13.
/// `duplicate`: no two candidates are the same point; mirror images are two.
/// `alternation`: the crossings of a path go up and down in turn.
/// `assessed`: the harness's own checks hold.
Violations check_report(const Scene& scene, const SolveReport& report);

/// `count`: what is claimed does not exceed the known counts of a shipped instance and equals them where the
/// claim says so. Instances without known counts pass.
Violations check_counts(std::string_view instance, const Scene& scene, const SolveReport& report);

/// `certificate`: every solution is proven to exist, to be real or not as reported and a class of its own,
/// and no more are proven than there can be. Those reported as multiple pass, and scenes out of certificates'
/// reach.
Violations check_certificates(const Scene& scene, const SolveReport& report);

/// `repeatable`: the same object, another object, one that has solved `other` before, one that is watched and
/// one with two threads report the same bits.
Violations check_repeatability(const Subject& subject, const Scene& scene, const Scene& other);

/// `reuse`: prepared with one scene, a strategy finds in another scene of the same graph what it finds when
/// it is prepared with that one. Precondition: both scenes are supported.
Violations check_reuse(const Subject& subject, const Scene& prepared, const Scene& scene);

/// `stop`: a request that stands from the beginning ends the solve with the status stopped and less than a
/// quarter of the work; one that comes on the way ends it too. What is reported is valid and part of
/// `whole`, which the subject reports when nothing stops it.
Violations check_stop(const Subject& subject, const Scene& scene, const SolveReport& whole);

/// Other names, orders, a mirror image and other units.
std::vector<Restatement> restatements(const ProblemStatement& problem, std::mt19937_64& random);

/// The name of a restatement: the restated problem has the same solutions, in the same order along S; where
/// only the unit of length changes (that of options which are lengths too), the report is the same bit for
/// bit.
Violations check_restatements(const Subject& subject, const ProblemStatement& problem,
                              const std::vector<Restatement>& restatements);

}  // namespace gcs::contract
