#include "harness/results/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "harness/base/record_fields.hpp"
#include "solvers/answers/certify.hpp"
#include "solvers/certificates/coincidences.hpp"
#include "solvers/certificates/scene_equations.hpp"

namespace gcs {
namespace {

/// Of the scene's size: where a result states no bound of its own.
constexpr double default_error = 1e-12;

/// Precise enough for a distance that doubles overestimate.
constexpr int precise_bits = 128;

class Verifier {
 public:
  Verifier(const StoredResult& result, const ProofSetup& setup)
      : result_(result), scene_(result.scene), setup_(setup), equations_(scene_) {
    for (const AssessedSolution& solution : result.answer.solutions) figures_.push_back(solution.figure);
    proofs_ = prove_solutions(equations_, signs_, figures_, setup_);
    standings_.assign(proofs_.size(), Standing::as_stated);
  }

  Verification run() {
    for (std::size_t i = 0; i < proofs_.size(); ++i) check_solution(i);
    if (result_.answer.claim == Claim::all_complex && is_complete()) check_conjugates();
    summarise();
    check_counts();
    check_totals();
    check_limit();
    return std::move(verification_);
  }

 private:
  void mismatch(const char* name, std::string what) {
    verification_.mismatches.push_back({name, std::move(what)});
  }

  bool is_complete() const { return result_.answer.status == RunStatus::complete; }

  void check_solution(std::size_t i) {
    const SolutionProof& proof = proofs_[i];
    const Certificate& certificate = proof.certificate;
    if (!certificate.is_isolated()) {
      mismatch("solution", fmt::format("solution {} is not proven: {}", i, certificate.cause));
      return;
    }
    check_distance(i);
    check_multiplicity(i);
    if (proof.same_as >= 0)
      mismatch("class",
               fmt::format("solution {} is {} class as solution {}", i,
                           proof.is_proven_same ? "the same" : "not proven to be another", proof.same_as));
    if (!certificate.holds_one()) return;
    check_realness(i);
    if (certificate.realness == Certificate::Realness::real && !signs_.empty()) check_signs(i);
  }

  /// Where the proof leaves the signs undecided that constraints state, any standing may be listed.
  void check_signs(std::size_t i) {
    const Standing listed = result_.answer.solutions[i].signs.standing;
    standings_[i] = proofs_[i].signs.standing;
    if (standings_[i] != Standing::undecided && standings_[i] != listed)
      mismatch("standing", fmt::format("solution {} is listed as '{}' and proven to be '{}'", i, word(listed),
                                       word(standings_[i])));
  }

  void check_multiplicity(std::size_t i) {
    const Certificate& certificate = proofs_[i].certificate;
    const int proven = certificate.is_proven ? 1 : certificate.cluster;
    const int listed = result_.answer.solutions[i].multiplicity;
    if (!proofs_[i].fits(listed))
      mismatch("multiplicity",
               fmt::format("solution {} is listed with multiplicity {}, and {} solutions are proven to lie "
                           "there, counted with multiplicities",
                           i, listed, proven));
  }

  /// Of a cluster nothing is known.
  void check_realness(std::size_t i) {
    using Realness = Certificate::Realness;
    const bool is_real = result_.answer.solutions[i].figure.is_real();
    if (proofs_[i].certificate.realness != (is_real ? Realness::real : Realness::not_real))
      mismatch("real",
               fmt::format("solution {} is listed as {}, which is not so", i, is_real ? "real" : "complex"));
  }

  /// In the scene's unit.
  double precise_distance(std::size_t i) const {
    const Certifier certifier(equations_.system());
    const Certificate precise = certifier.certify(equations_.coordinates(figures_[i]), precise_bits);
    return precise.is_isolated() ? equations_.distance(figures_[i], precise) : proofs_[i].distance;
  }

  void check_distance(std::size_t i) {
    const std::optional<double> stated = result_.answer.solutions[i].error_bound;
    const double bound = stated.value_or(default_error * scene_.size());
    if (proofs_[i].distance <= bound) return;
    const double distance = precise_distance(i);
    if (distance <= bound) return;
    mismatch("solution",
             fmt::format("solution {} is {:.2g} away from the proven one next to it, more than {} {:.2g}", i,
                         std::ldexp(distance, scene_.unit_exponent()),
                         stated ? "its error bound" : "1e-12 of the scene's size,",
                         std::ldexp(bound, scene_.unit_exponent())));
  }

  /// Lengths are real: the conjugate of a solution is another one, or of the same class.
  void check_conjugates() {
    std::vector<std::size_t> isolated;
    for (std::size_t i = 0; i < proofs_.size(); ++i)
      if (proofs_[i].certificate.is_isolated()) isolated.push_back(i);
    const std::size_t count = isolated.size();
    const auto box_of = [&](std::size_t k) {  // the second half are conjugates
      const std::size_t i = isolated[k % count];
      Enclosure box = box_around(equations_.coordinates(figures_[i]), proofs_[i].place);
      if (k >= count)
        for (std::complex<double>& value : box.mid) value = std::conj(value);
      return box;
    };
    std::set<std::size_t> met;
    for (const Coincidence& pair : coincidences(2 * count, box_of, equations_.system().mirror)) {
      const auto first = static_cast<std::size_t>(pair.first), second = static_cast<std::size_t>(pair.second);
      if (first < count && second >= count) met.insert(second - count);
    }
    for (std::size_t k = 0; k < count; ++k)
      if (!met.contains(k))
        mismatch("conjugate",
                 fmt::format("the conjugate of solution {} is not in a list that is said to be complete",
                             isolated[k]));
  }

  void check_counts() {
    Assessment own = result_.answer;
    recount(own);
    const ResultCounts expected = stated_counts(scene_.problem(), own.counts);
    std::vector<std::optional<Natural>> given;
    visit_counts(result_.stated.counts,
                 [&](const std::string&, const auto& count) { given.emplace_back(count); });
    std::size_t i = 0;
    visit_counts(expected.counts, [&](const std::string& name, const auto& count) {
      check_count(name, given[i++], std::optional<Natural>(count));
    });
    if (result_.stated.real) check_count("real", result_.stated.real, expected.real);
    if (result_.stated.complex) check_count("complex", result_.stated.complex, expected.complex);
    if (!signs_.empty()) {
      const Counts& stated = result_.stated.counts;
      check_count("not_as_stated", std::optional<Natural>(stated.not_as_stated),
                  std::optional<Natural>(expected.counts.not_as_stated));
      check_count("undecided", std::optional<Natural>(stated.undecided),
                  std::optional<Natural>(expected.counts.undecided));
    }
    check_convention(*expected.convention);
  }

  void check_count(const std::string& name, const std::optional<Natural>& given,
                   const std::optional<Natural>& own) {
    const auto text = [](const std::optional<Natural>& one) { return one ? one->decimal() : "not known"; };
    if (own != given)
      mismatch("count",
               fmt::format("the count {} is {}, and the list gives {}", name, text(given), text(own)));
  }

  void check_convention(Convention own) {
    const std::optional<Convention>& given = result_.stated.convention;
    if (given && *given != own)
      mismatch("convention", fmt::format("solutions are said to be counted {}, and the scene's are {}",
                                         word(*given), word(own)));
  }

  /// Of a product there may be more than are listed.
  void check_totals() {
    if (!result_.answer.totals) return;
    const SolutionTotals& totals = *result_.answer.totals;
    const auto& solutions = result_.answer.solutions;
    const Natural listed(solutions.size());
    const Natural real(static_cast<std::uint64_t>(
        std::ranges::count_if(solutions, [](const auto& one) { return one.figure.is_real(); })));
    check_total("real", totals.real, real);
    check_total("complex", totals.complex, listed);
    const std::optional<Natural>& all = totals.complex ? totals.complex : totals.real;
    if (is_complete() && all && *all != listed)
      mismatch("count", fmt::format("a list that is said to be complete has {} of {} solutions",
                                    listed.decimal(), all->decimal()));
  }

  void check_total(const char* name, const std::optional<Natural>& total, const Natural& listed) {
    if (total && *total < listed)
      mismatch("count", fmt::format("in all there are {} {} solutions, and {} are listed", total->decimal(),
                                    name, listed.decimal()));
  }

  /// No lengths have more solutions than theory allows.
  void check_limit() {
    const std::optional<Natural>& limit = verification_.proofs.limit;
    if (!limit) return;
    const Counts& counts = result_.answer.counts;
    for (const auto& [name, count] : {std::pair("real_up_to_reflection", counts.real_up_to_reflection),
                                      std::pair("complex_up_to_reflection", counts.complex_up_to_reflection),
                                      std::pair("generic", counts.generic)})
      if (count && *count > *limit)
        mismatch("count", fmt::format("the count {} is {}, and no lengths have more than {} solutions", name,
                                      count->decimal(), limit->decimal()));
  }

  void summarise() {
    Proofs& proofs = verification_.proofs;
    for (std::size_t i = 0; i < proofs_.size(); ++i) {
      const Certificate& certificate = proofs_[i].certificate;
      if (!proofs_[i].counts()) continue;
      ++proofs.classes;
      proofs.multiple += certificate.is_multiple ? 1 : 0;
      const bool is_real = certificate.realness == Certificate::Realness::real;
      proofs.real += is_real && standings_[i] == Standing::as_stated ? 1 : 0;
      proofs.undecided += is_real && standings_[i] == Standing::undecided ? 1 : 0;
      proofs.most_bits = std::max(proofs.most_bits, certificate.bits);
    }
    count_clusters_and_images(proofs_, proofs);
    prove_escaping(scene_, result_.answer.escaping, setup_, proofs);
    set_limit(theoretical_counts(scene_.problem()), proofs);
  }

  const StoredResult& result_;
  const Scene& scene_;
  ProofSetup setup_;
  const SceneEquations equations_;
  const std::vector<StatedSign> signs_ = stated_signs(scene_.problem());
  std::vector<Figure> figures_;
  std::vector<SolutionProof> proofs_;
  std::vector<Standing> standings_;  ///< proven, of each solution
  Verification verification_;
};

}  // namespace

Verification verify(const StoredResult& result, int threads, Monitor* monitor) {
  return Verifier(result, {.threads = threads, .monitor = monitor}).run();
}

}  // namespace gcs
