#include "solvers/reduction/step_solver.hpp"

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "solvers/homotopies/distinct_ends.hpp"
#include "solvers/homotopies/general_report.hpp"
#include "solvers/homotopies/total_degree.hpp"

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

int degree(const Monomial& monomial) { return (monomial.u >= 0) + (monomial.v >= 0); }

/// A system with x_i^(d_i) and 1 among the monomials of equation i, and the coefficients on both ends of the way to it.
struct FromRoots {
  MonomialSystem system;
  ComplexVectorX from, to;
  std::vector<int> degrees;

  FromRoots(const MonomialSystem& target, const ComplexVectorX& coefficients, std::mt19937_64& random) {
    system.unknowns = target.unknowns;
    for (int i = 0; i < target.equations(); ++i) {
      int highest = 0;
      for (int j = target.first[i]; j < target.first[i + 1]; ++j) {
        append(target.monomials[j], 0, coefficients[j]);
        highest = std::max(highest, degree(target.monomials[j]));
      }
      const Complex gamma =
          std::polar(1.0, std::uniform_real_distribution<double>(0, 2 * std::numbers::pi)(random));
      add_start({i, highest == 2 ? i : -1}, gamma);
      add_start({-1, -1}, -gamma);
      system.first.push_back(static_cast<int>(system.monomials.size()));
      degrees.push_back(highest);
    }
  }

 private:
  void append(const Monomial& monomial, const Complex& at_start, const Complex& at_end) {
    system.monomials.push_back(monomial);
    from.push_back(at_start);
    to.push_back(at_end);
  }

  void add_start(const Monomial& monomial, const Complex& coefficient) {
    for (auto j = static_cast<std::size_t>(system.first.back()); j < from.size(); ++j)
      if (system.monomials[j].u == monomial.u && system.monomials[j].v == monomial.v) {
        from[j] = coefficient;
        return;
      }
    append(monomial, coefficient, 0);
  }
};

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
    take_starts(followed_from_roots());
    if (missing_.in_words().empty()) break;
  }
  if (starts_.empty()) return;
  std::vector<ComplexVectorX> jacobians;
  for (std::size_t i = 0; i < std::min(samples, starts_.size()); ++i)
    jacobians.push_back(jacobian_at(system_, parameters_, starts_[i]));
  elimination_ = order_elimination(system_.unknowns, jacobians);
  tracking_ = std::make_unique<LegTracking>(system_, elimination_, setup_for(means_));
}

std::vector<PathEnd> StepSolver::followed_from_roots() {
  const FromRoots way(system_, parameters_, random_);
  const std::vector<ComplexVectorX> roots = roots_of_unity(way.degrees);
  const Elimination elimination = order_elimination(way.system, roots, way.from, way.to, random_);
  LegTracking tracking(way.system, elimination, setup_for(means_));
  return followed(way.system, tracking, roots, way.from, way.to, first_work_);
}

/// Of ends that are met again by another path a step has jumped.
void StepSolver::take_starts(const std::vector<PathEnd>& ends) {
  const SignMasks none(std::vector<int>(static_cast<std::size_t>(system_.unknowns), -1));
  missing_.jumps = DistinctEnds(ends, none, random_).jumps();
  const DistinctEnds distinct(ends, signs_, random_);
  starts_.clear();
  for (int i = 0; i < distinct.size(); ++i)
    if (!distinct.is_singular(i)) starts_.push_back(distinct[i]);
}

/// Counts the paths that are lost.
std::vector<PathEnd> StepSolver::followed(const MonomialSystem& system, LegTracking& tracking,
                                          const std::vector<ComplexVectorX>& starts,
                                          const ComplexVectorX& from, const ComplexVectorX& to,
                                          WorkCounters& work) {
  const auto is_zero = [&](const ComplexVectorX& x) { return is_zero_at(system, to, x); };
  const auto stopped = [&] { return means_.stop.stop_requested(); };
  std::vector<PathEnd> ends = follow_to_end(
      tracking, starts, from, to, is_zero, stopped, [](double) {}, work);
  settle(system, to, ends);
  for (const PathEnd& end : ends)
    if (end.kind == PathEnd::Kind::failed) ++missing_.lost[end.cause].count;
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
  const std::vector<PathEnd> ends = followed(system_, *tracking_, starts_, parameters_, coefficients, work);
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
  return starts_.empty() ? "no solution was found at random numbers" : missing_.in_words();
}

}  // namespace gcs
