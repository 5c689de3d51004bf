#include "solvers/homotopies/general_start.hpp"

#include <functional>
#include <utility>

#include "solvers/figures/residual_and_condition.hpp"
#include "solvers/homotopies/complex_report.hpp"
#include "solvers/homotopies/conjugate_ends.hpp"
#include "solvers/homotopies/general_report.hpp"
#include "solvers/homotopies/precise_ends.hpp"

namespace gcs {
namespace {

/// Whether the difference of both is in values alone.
bool are_of_one_family(const GeneralEquations& a, const GeneralEquations& b) {
  if (a.system.first != b.system.first || a.value_monomial != b.value_monomial) return false;
  for (std::size_t j = 0; j < a.coefficients.size(); ++j) {
    const Monomial &m = a.system.monomials[j], &n = b.system.monomials[j];
    if (m.u != n.u || m.v != n.v) return false;
  }
  ComplexVectorX known = a.coefficients, other = b.coefficients;
  for (const int j : a.value_monomial)
    if (j >= 0) known[j] = other[j] = 0;
  return known == other;
}

}  // namespace

GeneralStart::GeneralStart(GeneralEquations given, std::uint64_t seed, const TrackingSetup& setup)
    : random(seed),
      equations(sharing_coefficients(std::move(given))),
      family(family_of(equations)),
      elimination(order_elimination(equations.system, family, random)),
      tracking(equations.system, elimination, setup) {}

bool GeneralStart::serves(const GivenScene& given) const {
  return are_of_one_family(equations, given.equations);
}

SolveReport GeneralStart::carried_to_values(const SolveRequest& request, const GivenScene& scene,
                                            const std::function<void(double)>& progress) {
  const GeneralEquations& given = scene.equations;
  const auto stopped = [&] { return request.stop.stop_requested(); };
  const auto is_zero = [&](const ComplexVectorX& x) {
    return is_zero_at(given.system, given.coefficients, x);
  };
  WorkCounters all_work = work;
  std::vector<PathEnd> ends = follow_to_end(tracking, solutions, parameters, given.coefficients, is_zero,
                                            stopped, progress, all_work);
  std::mt19937_64 keys(request.seed);
  const auto make_report = [&] {
    std::vector<LostPath> lost = end_at_conjugates(
        [&](const ComplexVectorX& x) { return keeps_rank(jacobian_at(given.system, given.coefficients, x)); },
        given.signs, keys, ends);
    SolveReport made = general_report(scene.system, given, ends, all_work, keys, request.stop);
    restore(std::move(lost), ends);
    return made;
  };
  const auto before = [&](const std::vector<std::size_t>& numbers, double sigma) {
    std::vector<ComplexVectorX> starts;
    for (const std::size_t i : numbers) starts.push_back(solutions[i]);
    return follow_to_radius(tracking, std::move(starts), parameters, given.coefficients, sigma, stopped,
                            all_work);
  };
  SolveReport report = make_report();
  const bool has_doubts = report.status == SolveStatus::partial;
  const auto determine = [&](const std::function<bool(const Figure&)>& is_doubtful) {
    const auto is_open = [&](const PathEnd& end) {
      if (end.kind == PathEnd::Kind::at_infinity) return true;
      return has_doubts &&
             (end.kind != PathEnd::Kind::regular || is_doubtful(scene.system.figure(end.x, false)));
    };
    return determine_ends(given, parameters, is_open, before, request.threads, ends, request.stop);
  };
  const auto determine_stiff = [&] {
    const FigureJudge judge(scene.system);
    return determine([&](const Figure& figure) { return judge.is_stiff(figure); });
  };
  // Stiff ends are many where a scene is large and, of those, nearly all are right.
  if ((has_doubts && determine_stiff()) ||
      determine([&](const Figure& figure) { return loses_distances(request.scene, figure); }))
    report = make_report();
  conclude_stopped(request.stop, report);
  ends = std::vector<PathEnd>();  // they may be as large as the start, which the report may need again
  report.particulars.insert(report.particulars.begin(), particulars.begin(), particulars.end());
  // Certificates are of these equations in general scenes alone, not in those of points and several lines.
  if (request.scene.problem().is_general() && !is_stopped && !solutions.empty())
    report.generic_member = GenericMember{values_of(equations, parameters), solutions};
  if (missing.empty()) {
    report.generic = solutions.size();
    return report;
  }
  report.reason = missing + (report.reason.empty() ? "" : "; " + report.reason);
  if (report.status != SolveStatus::stopped)
    report.status = is_stopped ? SolveStatus::stopped : SolveStatus::partial;
  return report;
}

}  // namespace gcs
