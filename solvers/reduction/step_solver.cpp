#include "solvers/reduction/step_solver.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "solvers/homotopies/distinct_ends.hpp"
#include "solvers/homotopies/general_report.hpp"
#include "solvers/polyhedral/eliminated_equations.hpp"
#include "solvers/polyhedral/polyhedral_homotopies.hpp"
#include "solvers/polyhedral/supports_paths.hpp"

namespace gcs {
namespace {

using Complex = std::complex<double>;

/// A search at random parameters may lose a path by rounding, and another one does not.
constexpr int most_attempts = 3;

/// Jacobians by which an order of elimination is chosen.
constexpr std::size_t samples = 3;

TrackingSetup setup_for(const SolveMeans& means) {
  TrackingSetup setup;
  setup.set = widest_instruction_set();
  setup.threads = means.threads;
  return setup;
}

}  // namespace

StepSolver::StepSolver(const GeneralEquations& whole, const PlacingStep& step, const SolveMeans& means)
    : of_whole_(whole.coefficients), signs_(step.signs), means_(means), random_(means.seed) {
  take_equations(whole, step);
  find_starts();
}

void StepSolver::take_equations(const GeneralEquations& whole, const PlacingStep& step) {
  std::vector<int> number(static_cast<std::size_t>(whole.system.unknowns), -1);
  for (std::size_t i = 0; i < step.unknowns.size(); ++i)
    number[static_cast<std::size_t>(step.unknowns[i])] = static_cast<int>(i);
  const auto local = [&](int unknown) {
    return unknown < 0 ? -1 : number[static_cast<std::size_t>(unknown)];
  };
  system_.unknowns = static_cast<int>(step.unknowns.size());
  for (const int e : step.equations) {
    std::map<std::pair<int, int>, Term> terms;
    for (int j = whole.system.first[static_cast<std::size_t>(e)];
         j < whole.system.first[static_cast<std::size_t>(e) + 1]; ++j) {
      const Monomial& monomial = whole.system.monomials[static_cast<std::size_t>(j)];
      const int u = local(monomial.u), v = local(monomial.v);
      Addend addend{static_cast<std::size_t>(j), u < 0 ? monomial.u : -1, v < 0 ? monomial.v : -1};
      Term& term = terms[{std::max(u, v), std::min(u, v)}];
      term.is_parameter = term.is_parameter || addend.first >= 0 || addend.second >= 0 ||
                          j == whole.value_monomial[static_cast<std::size_t>(e)];
      term.addends.push_back(addend);
    }
    for (auto& [monomial, term] : terms) {
      system_.monomials.push_back({monomial.first, monomial.second});
      terms_.push_back(std::move(term));
    }
    system_.first.push_back(static_cast<int>(system_.monomials.size()));
  }
}

ComplexVectorX StepSolver::random_parameters() {
  std::normal_distribution<double> normal;
  ComplexVectorX coefficients;
  for (const Term& term : terms_) {
    Complex value = 0;
    for (const Addend& addend : term.addends) value += of_whole_[addend.coefficient];
    if (term.is_parameter) {
      const double real = normal(random_);
      value = Complex(real, normal(random_));
    }
    coefficients.push_back(value);
  }
  return coefficients;
}

void StepSolver::find_starts() {
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    missing_ = {};
    parameters_ = random_parameters();
    find_starts_at_parameters();
    if (missing().empty()) break;
  }
  if (starts_.empty()) return;
  std::vector<ComplexVectorX> jacobians;
  for (std::size_t i = 0; i < std::min(samples, starts_.size()); ++i)
    jacobians.push_back(jacobian_at(system_, parameters_, starts_[i]));
  elimination_ = order_elimination(system_, jacobians);
  tracking_ = std::make_unique<LegTracking>(system_, elimination_, setup_for(means_));
}

/// Of ends that are met again by another path a step has jumped.
void StepSolver::find_starts_at_parameters() {
  const auto [supports, coefficients] = eliminated_equations(system_, parameters_);
  const SignMasks divided = symmetric_signs(supports, signs_);
  const SupportsPaths paths = follow_supports(
      supports, coefficients, divided,
      {setup_for(means_), means_.seed, means_.stop, [](std::string_view, double) {}, "random numbers"},
      random_, first_work_);
  missing_starts_ = paths.missing;
  count_lost(paths.ends);
  missing_.jumps = DistinctEnds(paths.ends, divided, random_).jumps();
  const DistinctEnds distinct(paths.ends, signs_, random_);
  starts_.clear();
  for (int i = 0; i < distinct.size(); ++i)
    if (!distinct.is_singular(i)) starts_.push_back(distinct[i]);
}

void StepSolver::count_lost(const std::vector<PathEnd>& ends) {
  for (const PathEnd& end : ends)
    if (end.kind == PathEnd::Kind::failed) ++missing_.lost[end.cause].count;
}

std::vector<PathEnd> StepSolver::followed_to(const ComplexVectorX& coefficients, WorkCounters& work) {
  const auto is_zero = [&](const ComplexVectorX& x) { return is_zero_at(system_, coefficients, x); };
  const auto stopped = [&] { return means_.stop.stop_requested(); };
  std::vector<PathEnd> ends = follow_to_end(
      *tracking_, starts_, parameters_, coefficients, is_zero, stopped, [](double) {}, work);
  settle(system_, coefficients, means_.threads, ends);
  count_lost(ends);
  return ends;
}

ComplexVectorX StepSolver::coefficients_at(const ComplexVectorX& x) const {
  const auto factor = [&](int unknown) {
    return unknown < 0 ? Complex(1) : x[static_cast<std::size_t>(unknown)];
  };
  ComplexVectorX coefficients;
  for (const Term& term : terms_) {
    Complex value = 0;
    for (const Addend& addend : term.addends)
      value += of_whole_[addend.coefficient] * factor(addend.first) * factor(addend.second);
    coefficients.push_back(value);
  }
  return coefficients;
}

std::vector<StepWay> StepSolver::ways(const ComplexVectorX& x, bool is_real, WorkCounters& work) {
  add(std::exchange(first_work_, {}), work);
  const ComplexVectorX coefficients = coefficients_at(x);
  if (starts_.empty()) return {};
  const std::vector<PathEnd> ends = followed_to(coefficients, work);
  const DistinctEnds distinct(ends, signs_, random_);
  missing_.jumps += distinct.jumps();
  has_all_somewhere_ = has_all_somewhere_ || distinct.size() == static_cast<int>(starts_.size());
  std::vector<StepWay> found;
  for (int i = 0; i < distinct.size(); ++i) {
    const std::optional<ComplexVectorX> real =
        is_real ? real_end(system_, coefficients, distinct[i], distinct.is_singular(i)) : std::nullopt;
    missing_.lonely += is_real && !distinct.has_conjugate(i);
    found.push_back(
        {real.value_or(distinct[i]), real.has_value(), distinct.is_singular(i) ? distinct.paths(i) : 1});
  }
  return found;
}

std::string StepSolver::missing() const {
  if (starts_.empty()) return "no solution was found at random numbers";
  return missing_starts_.empty() ? missing_.in_words() : missing_starts_;
}

}  // namespace gcs
